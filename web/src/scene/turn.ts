// Roots that turn with their links when these are shown displaced.

/**
 * Turn the quaternion of each link's root by the shortest way from the direction in which the link leaves the root in
 * the lines `from` to that in the lines `to`, both [L, S, 3]; links without length keep theirs.
 */
export function turnAlong(roots: Float32Array, from: ArrayLike<number>, to: ArrayLike<number>, stations: number): void {
  for (let link = 0; 4 * link < roots.length && stations > 1; link++) {
    const a = 3 * stations * link;
    const ax = from[a + 3] - from[a];
    const ay = from[a + 4] - from[a + 1];
    const az = from[a + 5] - from[a + 2];
    const bx = to[a + 3] - to[a];
    const by = to[a + 4] - to[a + 1];
    const bz = to[a + 5] - to[a + 2];
    const sizes = Math.hypot(ax, ay, az) * Math.hypot(bx, by, bz);
    if (sizes > 0)
      turn(
        roots,
        4 * link,
        ay * bz - az * by,
        az * bx - ax * bz,
        ax * by - ay * bx,
        sizes + ax * bx + ay * by + az * bz,
      );
  }
}

/** Multiply the quaternion at `k` from the left by one of any length. */
function turn(q: Float32Array, k: number, x: number, y: number, z: number, w: number): void {
  const size = Math.hypot(x, y, z, w);
  if (size === 0) return;
  const qx = q[k] / size;
  const qy = q[k + 1] / size;
  const qz = q[k + 2] / size;
  const qw = q[k + 3] / size;
  q[k] = w * qx + x * qw + y * qz - z * qy;
  q[k + 1] = w * qy - x * qz + y * qw + z * qx;
  q[k + 2] = w * qz + x * qy - y * qx + z * qw;
  q[k + 3] = w * qw - x * qx - y * qy - z * qz;
}
