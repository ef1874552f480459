// Aiming a camera: all places between two edges of the picture, from as near as that can be.

/** Where to aim in one direction of the picture, so that all is between `low` and `high` of its half size. */
export class Aim {
  /** The least from which that can be [m]. */
  readonly distance: number;
  private readonly first: number;
  private readonly last: number;
  private readonly low: number;
  private readonly high: number;

  /** `depths`: of the places towards the camera; `tangent`: of half the angle that the picture is wide. */
  constructor(at: Float64Array, depths: Float64Array, tangent: number, low: number, high: number) {
    let [first, last] = [Infinity, -Infinity];
    [this.low, this.high] = [tangent * low, tangent * high];
    at.forEach((place, k) => {
      first = Math.min(first, place + this.low * depths[k]);
      last = Math.max(last, place + this.high * depths[k]);
    });
    [this.first, this.last] = [first, last];
    this.distance = (last - first) / (this.high - this.low);
  }

  /** What is in the middle of the picture, seen from a distance [m]. */
  from(distance: number): number {
    return (this.first + this.last - (this.low + this.high) * distance) / 2;
  }
}
