//! What the edges of fibres carry along themselves, to be looked at.

use super::force::FibreForce;
use glam::DVec3;

impl FibreForce {
    /// Puts the force [N] that every edge carries between the particles at `positions` into `lines`, one entry an edge
    /// of each of the body's centre lines: `l_f EA (|e| - l) / l0`, l what they rest at at the end of the last step,
    /// and the pull of the muscle then; negative where it is pressed. Broken edges carry nothing; entries of edges that
    /// are none of these fibres' are left as they are.
    pub fn tensions(&self, positions: &[DVec3], lines: &mut [Vec<f64>]) {
        let mut broken = self.broken.edges.iter();
        let mut first_edge = 0;
        for fibre in self.fibres.iter() {
            let x: Vec<DVec3> = fibre.vertices.iter().map(|vertex| vertex.gather(positions)).collect();
            let tension = fibre.tensions(&x, self.activity.time());
            for (k, &broken) in (0..fibre.edges.len()).zip(broken.by_ref()) {
                let line = lines.get_mut(fibre.line as usize);
                if let Some(entry) = line.and_then(|line| line.get_mut(fibre.first_vertex as usize + k)) {
                    *entry =
                        if broken { 0.0 } else { tension(k) - fibre.edges[k].0 * self.yielded.stretch(first_edge + k) };
                }
            }
            first_edge += fibre.edges.len();
        }
    }

    /// Puts the drive at every edge at the end of the last step, and the share by which that has it want to be shorter,
    /// into `lines`, one entry an edge of each of the body's centre lines; entries of edges that do not act are left as
    /// they are.
    pub(crate) fn activations(&self, lines: &mut [Vec<[f64; 2]>]) {
        for fibre in self.fibres.iter() {
            let Some(value) = fibre.activations(self.activity.time()) else { continue };
            for k in 0..fibre.edges.len() {
                let line = lines.get_mut(fibre.line as usize);
                if let Some(entry) = line.and_then(|line| line.get_mut(fibre.first_vertex as usize + k)) {
                    *entry = value(k);
                }
            }
        }
    }
}
