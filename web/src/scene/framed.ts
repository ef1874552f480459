// A picture of the scene that can be taken along: title, background, robot, and all that is written over it.

const EVEN = 2; // sizes that films take
const BAND = 30; // px of the page above the picture, for its title

/**
 * Draw layers of `ratio` pixels for one of the page on a canvas, under a title, with the notes over `place` as they are
 * seen; `stops`: the colour scale from left to right.
 */
export function framed(
  canvas: HTMLCanvasElement, layers: HTMLCanvasElement[], place: HTMLElement, ratio: number, title: string,
  stops: string[],
): HTMLCanvasElement {
  const even = (size: number) => EVEN * Math.round((ratio * size) / EVEN);
  const { width, height } = place.getBoundingClientRect();
  const [wide, tall] = [even(width), even(height + BAND)];
  if (canvas.width !== wide || canvas.height !== tall) [canvas.width, canvas.height] = [wide, tall];
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  const colours = getComputedStyle(place);
  const colour = (name: string, usual: string) => colours.getPropertyValue(name).trim() || usual;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const sky = context.createLinearGradient(0, 0, 0, height + BAND);
  sky.addColorStop(0, colour("--sky", "#ffffff"));
  sky.addColorStop(1, colour("--earth", "#dddddd"));
  context.fillStyle = sky;
  context.fillRect(0, 0, width, height + BAND);
  context.fillStyle = colour("--ink", "#000000");
  context.font = "600 15px system-ui, sans-serif";
  context.fillText(title, 10, 20, width - 20);
  context.translate(0, BAND);
  for (const layer of layers) context.drawImage(layer, 0, 0, width, height);
  const notes = place.querySelectorAll<HTMLElement>(".scene-note:not([hidden])");
  notes.forEach((note) => write(context, place, note, stops));
  return canvas;
}

/** A note where it is seen: its ground, its swatches, its words one by one. */
function write(context: CanvasRenderingContext2D, place: HTMLElement, note: HTMLElement, stops: string[]): void {
  const from = place.getBoundingClientRect();
  const boxOf = (thing: Element | Range): [number, number, number, number] => {
    const { left, top, width, height } = thing.getBoundingClientRect();
    return [left - from.left, top - from.top, width, height];
  };
  context.fillStyle = getComputedStyle(note).backgroundColor;
  context.fillRect(...boxOf(note));
  for (const swatch of note.querySelectorAll("i")) {
    const [x, y, width, height] = boxOf(swatch);
    const scale = context.createLinearGradient(x, 0, x + width, 0);
    stops.forEach((stop, k) => scale.addColorStop(k / (stops.length - 1), stop));
    const { backgroundImage, backgroundColor } = getComputedStyle(swatch);
    context.fillStyle = backgroundImage === "none" ? backgroundColor : scale;
    context.fillRect(x, y, width, height);
  }
  const range = document.createRange();
  context.textBaseline = "middle";
  for (const texts = document.createTreeWalker(note, NodeFilter.SHOW_TEXT); texts.nextNode();) {
    const node = texts.currentNode as Text;
    const { color, fontWeight, fontSize, fontFamily } = getComputedStyle(node.parentElement ?? note);
    [context.fillStyle, context.font] = [color, `${fontWeight} ${fontSize} ${fontFamily}`];
    for (const word of node.data.matchAll(/\S+/g)) {
      range.setStart(node, word.index);
      range.setEnd(node, word.index + word[0].length);
      const [x, y, width, height] = boxOf(range);
      if (width > 0) context.fillText(word[0], x, y + height / 2);
    }
  }
  context.textBaseline = "alphabetic";
}
