// The one time of a page: the charts' cursor, the robot's pose and the elastic line all show it.

export interface Clock {
  /** Time shown [s]. */
  readonly time: number;
  /** End of the longest run [s]. */
  readonly duration: number;
  readonly playing: boolean;
  /** Simulated seconds in a second. */
  speed: number;
  /** Whether it starts again at the end. */
  loop: boolean;
  seek(time: number): void;
  play(): void;
  pause(): void;
  toggle(): void;
  /** A changed run may be shorter or longer. */
  setDuration(duration: number): void;
  /** `listener` is called after each change of time or of playing; returns what ends that. */
  subscribe(listener: (clock: Clock) => void): () => void;
}

export function makeClock(duration: number): Clock {
  const listeners = new Set<(clock: Clock) => void>();
  let frame = 0;
  let before = 0;
  const tell = () => listeners.forEach((listener) => listener(clock));
  const state = { time: 0, duration, playing: false };
  const step = (now: number) => {
    // the first frame may have begun before it was asked for
    const passed = Math.min(0.25, Math.max(0, (now - before) / 1000));
    before = now;
    state.time += passed * clock.speed;
    if (state.time >= state.duration) {
      state.time = clock.loop ? 0 : state.duration;
      state.playing = clock.loop;
    }
    tell();
    if (state.playing) frame = requestAnimationFrame(step);
  };
  const clock: Clock = {
    get time() {
      return state.time;
    },
    get duration() {
      return state.duration;
    },
    get playing() {
      return state.playing;
    },
    speed: 1,
    loop: true,
    seek(time) {
      state.time = Math.min(Math.max(time, 0), state.duration);
      tell();
    },
    play() {
      if (state.playing) return;
      state.playing = true;
      if (state.time >= state.duration) state.time = 0;
      before = performance.now();
      frame = requestAnimationFrame(step);
      tell();
    },
    pause() {
      state.playing = false;
      cancelAnimationFrame(frame);
      tell();
    },
    toggle() {
      if (state.playing) clock.pause();
      else clock.play();
    },
    setDuration(end) {
      state.duration = end;
      clock.seek(state.time);
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
  return clock;
}
