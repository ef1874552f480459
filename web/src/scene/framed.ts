// A picture of the scene that can be taken along: background, robot, and a line of words.

const EVEN = 2; // sizes that films take

/** Draw `shown` on a canvas of at least its size, between the colours of sky and earth, with words below. */
export function framed(
  canvas: HTMLCanvasElement, shown: HTMLCanvasElement, colour: (name: string) => string, words: string,
): HTMLCanvasElement {
  const [width, height] = [shown.width, shown.height].map((size) => EVEN * Math.floor(size / EVEN));
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  const sky = context.createLinearGradient(0, 0, 0, height);
  sky.addColorStop(0, colour("--sky").trim() || "#ffffff");
  sky.addColorStop(1, colour("--earth").trim() || "#dddddd");
  context.fillStyle = sky;
  context.fillRect(0, 0, width, height);
  context.drawImage(shown, 0, 0);
  const size = Math.max(12, Math.round(height / 36));
  context.font = `${size}px system-ui, sans-serif`;
  context.fillStyle = colour("--ink").trim() || "#000000";
  context.fillText(words, size, height - size, width - 2 * size);
  return canvas;
}
