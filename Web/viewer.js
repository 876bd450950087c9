// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Shows a scene on a canvas: coarse frames while the camera moves, then a complete one.
import {Camera} from "./camera.js";
import {errorColorTexture, errorLegend} from "./error_view.js";
import {Frames} from "./frames.js";
import {Picker} from "./picker.js";
import {checkPredicate} from "./predicate_check.js";
import {Programs} from "./programs.js";
import {Step} from "./step.js";

const MILLISECONDS_AT_REST = 150; // after the last movement

function contextOf(canvas)
{
  const gl = canvas.getContext(
    "webgl2", {alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true});
  if (!gl)
  {
    throw new Error(
      "This browser can't show the scene: it has no WebGL 2. Update the browser, or " +
      "switch hardware acceleration on in its settings.");
  }
  return gl;
}

// The level that draws as the written one.
function writtenLevel({adaptive, sampled, tolerance})
{
  return adaptive ? {name: "default", tolerance}
                  : {name: sampled ? "sampled" : "fast", tolerance: 1 / 255};
}

export class Viewer
{
  /** Throws an Error that says what this browser lacks. */
  constructor(canvas, scene, archive)
  {
    this.canvas = canvas;
    this.scene = scene;
    this.archive = archive;
    this.gl = contextOf(canvas);
    this.camera = new Camera(scene.camera);
    this.stepIndex = 0;
    this.shown = "picture";
    const [first] = scene.steps[0].volumes;
    this.levelSet = first ? writtenLevel(first.level) : {name: "default", tolerance: 1 / 255};
    this.edits = new Map();     // functions by volume
    this.unapplied = new Set(); // volumes whose edit waits for the next frame
    this.wanted = 0;            // number of the frame that is wanted
    this.onframe = (_report) => {};
    this.onerror = (_text) => {};
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => this.restore());
  }

  /** Reads the arrays of the first step, and compiles. */
  async load(onProgress = () => {})
  {
    const {gl, archive, scene} = this;
    if (!gl.getExtension("EXT_color_buffer_float"))
    {
      throw new Error("This browser's graphics can't draw floating-point numbers " +
                      "(EXT_color_buffer_float), which the scene needs. Try another browser.");
    }
    await archive.load([scene.shaders], () => {});
    const files = JSON.parse(new TextDecoder().decode(archive.array(scene.shaders)));
    this.programs = new Programs(gl, files, scene.symbols);
    this.frames = new Frames(gl, this.programs, errorColorTexture(gl));
    this.picker = new Picker(gl, this.programs);
    this.current = null;
    if (scene.steps.some(
          ({volumes}) => volumes.some(({features}) => !features.includes("STRUCTURED"))))
    {
      await checkPredicate(gl, this.programs);
    }
    await this.loadStep(onProgress);
  }

  async loadStep(onProgress = () => {})
  {
    const step = new Step(this.gl, this.scene.steps[this.stepIndex]);
    await step.load(this.archive, this.programs, this.current, onProgress);
    this.edits.forEach((functions, index) => this.apply(step, index, functions));
    this.current = step;
  }

  // After the context came back, nothing is on the GPU any more.
  async restore()
  {
    await this.guard(() => this.load());
    this.draw();
  }

  async guard(action)
  {
    try
    {
      return await action();
    }
    catch (error)
    {
      if (!this.gl.isContextLost())
      {
        this.onerror(error.message);
      }
      return false;
    }
  }

  get size() { return [this.canvas.width, this.canvas.height]; }

  /** [xMin, xMax, yMin, yMax, zMin, zMax] of all that is shown. */
  get bounds() { return this.current.bounds; }

  get drawnScene()
  {
    return {
      camera: this.camera,
      level: this.levelSet,
      background: this.scene.background,
      background2: this.scene.background2,
      volumes: this.current.ordered(this.camera),
      surfaces: this.current.surfaces
    };
  }

  resize(width, height)
  {
    // An observer of the size also tells the first one, perhaps when its frame has been drawn.
    if (this.canvas.width === width && this.canvas.height === height)
    {
      return;
    }
    this.canvas.width = width;
    this.canvas.height = height;
    this.hasDrawn ? this.drawSoon() : this.draw();
  }

  /** The camera has moved, and may go on to. */
  moved()
  {
    this.camera.resetClippingRange(this.current.bounds);
    this.drawSoon();
  }

  // A coarse frame now, and a complete one if nothing else happens.
  drawSoon()
  {
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.draw(), MILLISECONDS_AT_REST);
    this.begin(() => this.drawCoarse());
  }

  /** Draws a complete frame. */
  draw()
  {
    clearTimeout(this.rest);
    const drawn = this.begin((isWanted) => this.drawComplete(isWanted));
    if (!this.resolveComplete)
    {
      this.complete = new Promise((resolve) => { this.resolveComplete = resolve; });
    }
    drawn.then((complete) => {
      if (complete && this.resolveComplete)
      {
        this.resolveComplete();
        this.resolveComplete = null;
      }
    });
  }

  // A frame begins when the one before has noticed that it isn't wanted any more. Of coarse frames
  // each is drawn to its end, so that something is seen to move.
  begin(draw)
  {
    const number = ++this.wanted;
    const run = async () => {
      await this.running;
      await this.guard(() => this.applyEdits());
      return number === this.wanted && this.current && !this.gl.isContextLost() &&
             this.guard(() => draw(() => number === this.wanted));
    };
    const done = run();
    this.running = Promise.all([this.running, done]).then(() => {});
    return done;
  }

  // Runs an action that does not draw on the canvas, after the current frame; it cancels no frame.
  queue(action)
  {
    const done = Promise.resolve(this.running).then(() => this.guard(action));
    this.running = done.then(() => {});
    return done;
  }

  async drawCoarse()
  {
    const complete = await this.frames.drawCoarse(this.drawnScene, this.size, () => true);
    this.onframe({complete: false});
    return complete;
  }

  async drawComplete(isWanted)
  {
    const {frames, size} = this;
    const begun = performance.now();
    let counters = {};
    let complete;
    if (this.shown === "error")
    {
      counters = await frames.count(this.drawnScene, size, isWanted);
      complete = counters !== null;
      if (complete)
      {
        this.greatestBound = counters.errorBound;
        await frames.showErrors(size, this.errorRange);
      }
    }
    else
    {
      complete = await frames.drawComplete(this.drawnScene, size, isWanted);
    }
    if (complete)
    {
      this.hasDrawn = true;
      this.onframe({complete, milliseconds: performance.now() - begun, ...counters});
    }
    return complete;
  }

  /** The counters of a frame at rest: { rays, cells, errorBound, refused, lost, guarded }. */
  async count()
  {
    return this.queue(() => this.frames.count(this.drawnScene, this.size, () => true));
  }

  get errorRange()
  {
    const high = Math.log10(Math.max(this.greatestBound || 0, 1e-6));
    return [high - 3, high];
  }

  /** What a scalar bar of the view of errors shows; null before the first such frame. */
  get errorLegend()
  {
    return this.greatestBound === undefined ? null : errorLegend(this.errorRange);
  }

  get level() { return this.levelSet; }
  set level({name, tolerance})
  {
    this.levelSet = {name, tolerance};
    this.draw();
  }

  get show() { return this.shown; }
  set show(what)
  {
    this.shown = what;
    this.draw();
  }

  get step() { return this.stepIndex; }
  set step(index)
  {
    this.stepIndex = index;
    const loaded = this.begin(async () => {
      await this.loadStep();
      return true;
    });
    loaded.then(() => this.draw());
  }

  /** { color, opacity, nan } of a volume. */
  functions(index) { return this.edits.get(index) || this.current.volumes[index].functions[0]; }

  setFunctions(index, functions)
  {
    this.edits.set(index, functions);
    this.unapplied.add(index); // not at once: a frame may be drawing with the old tables
    this.draw();
  }

  applyEdits()
  {
    const waiting = this.current && !this.gl.isContextLost() ? [...this.unapplied] : [];
    waiting.forEach((index) => {
      this.unapplied.delete(index);
      this.apply(this.current, index, this.edits.get(index));
    });
  }

  apply(step, index, functions)
  {
    const volume = step.volumes[index];
    if (volume)
    {
      volume.setFunctions(functions, volume.levelFor(this.levelSet.name, this.levelSet.tolerance));
    }
  }

  /** The scalars of a volume, 0..1, for a histogram. */
  scalars(index) { return this.current.volumes[index].scalars; }

  /**
   * What a ray meets: { volume, cell, position, value }, or null. x, y: device pixels from the
   * upper left corner.
   */
  async pick(x, y)
  {
    const pixel = [Math.floor(x), this.canvas.height - 1 - Math.floor(y)];
    return this.queue(
      () => this.picker.pick(this.drawnScene, this.size, pixel, this.frames.base.depth));
  }

  toPng() { return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png")); }
}
