//! Whether time runs, how fast it is meant to, when the next frame is due, and how fast it really runs.

use std::time::{Duration, Instant};

/// Wall time over which rates are averaged.
const RATE_WINDOW: Duration = Duration::from_millis(500);

/// A frame this late is not made up for: the simulation is in slow motion then.
const GREATEST_DEBT: Duration = Duration::from_millis(100);

/// Longest wait for a frame, however slow the motion.
const LONGEST_WAIT: f64 = 1.0;

/// Paces frames by the clock.
pub(super) struct Playback {
    playing: bool,
    /// Simulated over wall time that is aimed at.
    speed: f64,
    /// Whether frames follow each other as fast as they can.
    hurries: bool,
    /// When the next frame is due; at once where none is planned.
    due: Option<Instant>,
    /// Frames since a time.
    counted: (u32, Instant),
    /// Simulated frames a wall second, and simulated over wall time, when last measured.
    rates: [f64; 2],
}

impl Playback {
    /// At normal speed.
    pub(super) fn new(playing: bool) -> Self {
        Self { playing, speed: 1.0, hurries: false, due: None, counted: (0, Instant::now()), rates: [0.0; 2] }
    }

    /// Whether time runs.
    pub(super) fn is_playing(&self) -> bool {
        self.playing
    }

    /// Lets time run or stand.
    pub(super) fn set_playing(&mut self, playing: bool) {
        self.playing = playing;
    }

    /// Lets time run, and measures the rate anew.
    pub(super) fn play(&mut self) {
        self.playing = true;
        self.measure_anew();
    }

    /// Aims at so much simulated over wall time.
    pub(super) fn set_speed(&mut self, speed: f64) {
        self.speed = speed;
    }

    /// Has frames follow each other as fast as they can, or by the clock again.
    pub(super) fn hurry(&mut self, hurries: bool) {
        self.hurries = hurries;
    }

    /// Forgets what went before in the rates to come.
    pub(super) fn measure_anew(&mut self) {
        self.counted = (0, Instant::now());
    }

    /// When the next frame is due.
    pub(super) fn due(&self) -> Instant {
        self.due.unwrap_or_else(Instant::now)
    }

    /// Whether the next frame is due now.
    pub(super) fn is_due(&self) -> bool {
        self.due.is_none_or(|due| Instant::now() >= due)
    }

    /// Plans no frame: what stands still has none to make up for.
    pub(super) fn rest(&mut self) {
        self.due = None;
    }

    /// Plans the next frame after one of so much simulated time [s].
    pub(super) fn plan_next(&mut self, frame_seconds: f64) {
        if self.hurries {
            self.due = None;
            return;
        }
        let frame = frame_seconds / self.speed.max(1e-3);
        let now = Instant::now();
        let earliest = now.checked_sub(GREATEST_DEBT).unwrap_or(now);
        let due = self.due() + Duration::from_secs_f64(frame.min(LONGEST_WAIT));
        self.due = Some(due.max(earliest));
    }

    /// Counts a frame of so much simulated time [s].
    pub(super) fn count_frame(&mut self, frame_seconds: f64) {
        let (frames, since) = &mut self.counted;
        *frames += 1;
        let elapsed = since.elapsed();
        if elapsed >= RATE_WINDOW {
            let rate = f64::from(*frames) / elapsed.as_secs_f64();
            self.rates = [rate, rate * frame_seconds];
            self.measure_anew();
        }
    }

    /// Simulated frames a wall second, and simulated over wall time.
    pub(super) fn rates(&self) -> [f64; 2] {
        self.rates
    }
}
