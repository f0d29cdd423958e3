// A worker's timers are not slowed down in a hidden tab. It only ticks: the page itself sends, so that a page that
// hangs falls silent and the cell stops what it jogs.
const BEAT_MS = 250;
setInterval(() => postMessage(0), BEAT_MS);
