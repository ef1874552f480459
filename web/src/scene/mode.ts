// A mode that swings about the robot's rest.
import { Group } from "three";
import type { Mode } from "../contract";
import type { Scene } from "../contract_scene";
import { Motion } from "./motion";
import { RobotView } from "./links";
import type { Shared } from "./run";
import { turnAlong } from "./turn";

/** Seconds of a swing on the screen, whatever the frequency. */
export const SWING = 1.6;

/** The lines of a mode, whatever draws them. */
export class Swinging {
  readonly motion: Motion;
  private readonly roots: Float32Array;

  /** `size`: the largest displacement [m]. */
  constructor(private readonly mode: Mode, scene: Scene, private readonly size: number) {
    const [links, stations] = mode.rest.shape;
    const once = { data: mode.rest.data, shape: [1, links, stations, 3] };
    const roots = { data: scene.roots.data.slice(0, 4 * links), shape: [1, links, 4] };
    const end = mode.rest.data.slice(3 * (links * stations - 1), 3 * links * stations);
    this.motion = new Motion({
      times: { data: Float64Array.of(0), shape: [1] }, line: once, rigid: once, reference: null, roots,
      tip: { data: end, shape: [1, 3] }, tipReference: null, colours: [], contact: null,
    }); // prettier-ignore
    this.motion.seek(0, 1, null);
    this.roots = this.motion.roots.slice();
  }

  /** At a phase [rad]: the displacement is the real part of (real + i imaginary) e^(i phase). */
  swing(phase: number): void {
    const { mode, motion, size } = this;
    const cosine = size * Math.cos(phase);
    const sine = size * Math.sin(phase);
    const { line, values } = motion;
    for (let k = 0; k < values.length; k++) {
      let away = 0;
      for (let c = 3 * k; c < 3 * k + 3; c++) {
        const moved = cosine * mode.real.data[c] - sine * mode.imaginary.data[c];
        line[c] = mode.rest.data[c] + moved;
        away += moved * moved;
      }
      values[k] = Math.sqrt(away) / size;
    }
    for (let c = 0; c < 3; c++) motion.tip[c] = line[line.length - 3 + c];
    motion.roots.set(this.roots);
    turnAlong(motion.roots, mode.rest.data, line, motion.stations);
  }
}

export class ModeView {
  readonly group = new Group();
  private readonly swinging: Swinging;
  private readonly robot: RobotView;
  private readonly rest: RobotView;

  /** `amplitude`: the largest displacement as a share of the robot's reach. */
  constructor(mode: Mode, scene: Scene, amplitude: number, shared: Shared) {
    const { colours, extent, fine } = shared;
    this.swinging = new Swinging(mode, scene, amplitude * extent.reach);
    const { motion } = this.swinging;
    const { link, joint, gear, base, payload, rigid } = colours;
    const look = { link, joint, gear, base, payload, opacity: 1, painted: "all", fine } as const;
    const faint = { ...look, link: rigid, opacity: 0.35, painted: "none" } as const;
    this.robot = new RobotView(scene, motion, look, extent);
    this.rest = new RobotView(scene, motion, faint, { ...extent, usual: 0.8 * extent.usual });
    this.group.add(this.robot.group, this.rest.group);
    this.rest.update(motion, motion.line, 0, 1);
  }

  swing(phase: number): void {
    const { motion } = this.swinging;
    this.swinging.swing(phase);
    this.robot.update(motion, motion.line, 0, 1);
  }

  dispose(): void {
    this.robot.dispose();
    this.rest.dispose();
    this.group.removeFromParent();
  }
}
