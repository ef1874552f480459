// Where in the picture there is room for the robot: what the notes over it leave free.

/** A part of the picture, as shares of its half width and height from its middle: left, right, below, above. */
export type Room = [number, number, number, number];

const MARGIN = 0.09;
const LEAST = 0.7; // of 2, the whole side: what is smaller is no room for a robot

export const WHOLE: Room = [-1 + MARGIN, 1 - MARGIN, -1 + MARGIN, 1 - MARGIN];

/** The parts that are as large as may be and free of notes: `left` and `right` above, `below` along the lower edge. */
export function roomsBetween(place: DOMRect, left: DOMRect, right: DOMRect, below: DOMRect): Room[] {
  if (place.width === 0 || place.height === 0) return [WHOLE];
  const across = (x: number) => (2 * (x - place.left)) / place.width - 1;
  const up = (y: number) => 1 - (2 * (y - place.top)) / place.height;
  const there = (box: DOMRect) => box.height > 0;
  const free: [number, number, number] = [
    there(left) ? across(left.right) : -1,
    there(right) ? across(right.left) : 1,
    there(below) ? up(below.top) : -1,
  ];
  const under = [left, right].map((box) => (there(box) ? up(box.bottom) : 1));
  const [from, to, floor] = free;
  const found: Room[] = [
    [-1, 1, floor, Math.min(...under)],
    [-1, to, floor, under[0]],
    [from, 1, floor, under[1]],
    [from, to, floor, 1],
  ];
  const inner = found.map(([a, b, c, d]): Room => [a + MARGIN, b - MARGIN, c + MARGIN, d - MARGIN]);
  const large = inner.filter(([a, b, c, d]) => b - a > LEAST && d - c > LEAST);
  return large.length ? large : [WHOLE];
}
