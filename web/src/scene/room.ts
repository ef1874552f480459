// Where in the picture there is room for the robot: what the notes over it leave free.

/** A part of the picture, as shares of its half width and height from its middle: left, right, below, above. */
export type Room = [number, number, number, number];

export interface Rooms {
  /** Parts of which one may hold the robot; notes may reach into them. */
  parts: Room[];
  notes: Room[];
}

const MARGIN = 0.09;
const LEAST = 0.7; // of 2, the whole side: what is smaller is no room for a robot

export const WHOLE: Rooms = { parts: [inside([-1, 1, -1, 1])], notes: [] };

/** The parts between any notes and edges of the picture. */
export function roomsBetween(place: DOMRect, boxes: DOMRect[]): Rooms {
  if (place.width === 0 || place.height === 0) return WHOLE;
  const across = (x: number) => (2 * (x - place.left)) / place.width - 1;
  const up = (y: number) => 1 - (2 * (y - place.top)) / place.height;
  const notes = boxes
    .filter(({ height }) => height > 0)
    .map((box): Room => [across(box.left), across(box.right), up(box.bottom), up(box.top)]);
  const parts = ways(notes, 0).flatMap(([a, b]) => ways(notes, 2).map(([c, d]) => inside([a, b, c, d])));
  const large = parts.filter(([a, b, c, d]) => b - a > LEAST && d - c > LEAST);
  return { parts: [...large, ...WHOLE.parts], notes };
}

/** Whether something is under a note, or so near that its thickness may be. */
export function isUnder({ notes }: Rooms, x: number, y: number): boolean {
  return notes.some(
    ([a, b, c, d]) => x > a - MARGIN / 2 && x < b + MARGIN / 2 && y > c - MARGIN / 2 && y < d + MARGIN / 2,
  );
}

/** From where to where in one direction: from an edge of the picture, from a note, or half into it. */
function ways(notes: Room[], side: 0 | 2): [number, number][] {
  const near = (edge: -1 | 1, at: 0 | 1) => {
    const ends = notes.map((note) => note[side + at]).filter((end) => end * edge > -0.3);
    return [...new Set([edge, ...ends.flatMap((end) => [end, (end + edge) / 2])])];
  };
  return near(-1, 1).flatMap((low) => near(1, 0).map((high): [number, number] => [low, high]));
}

function inside([a, b, c, d]: Room): Room {
  return [a + MARGIN, b - MARGIN, c + MARGIN, d - MARGIN];
}
