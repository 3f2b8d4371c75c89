//! Checks of what is painted.

use super::check::{At, Checked, fraction, positive, require, vector};
use crate::scene::{Dab, MAX_DABS};

pub(super) fn paint(at: &At<'_>, paint: &[Dab]) -> Checked {
    require(at, &[(); 0], paint.len() <= MAX_DABS, &format!("has {} dabs", paint.len()), || {
        format!("give at most {MAX_DABS}, with larger radii")
    })?;
    for (index, dab) in paint.iter().enumerate() {
        let at = at.item(index);
        vector(&at.field("center"), &dab.center, "m")?;
        positive(&at.field("radius"), dab.radius, "m")?;
        fraction(&at.field("value"), dab.value)?;
        fraction(&at.field("strength"), dab.strength)?;
    }
    Ok(())
}
