// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Mouse, touch and wheel move the camera, as in vtkInteractorStyleTrackballCamera.

const DEGREES_ACROSS = 200; // a drag from side to side
const DOLLY_BASE = 1.1;     // to the power of 10 for a drag from the middle to the top
const CLICK_PIXELS = 3;     // a mouse that moved less has clicked
const TAP_PIXELS = 10;      // a finger that moved less has tapped

/** The movement that a button starts: "rotate", "pan", "zoom", "roll" or null. */
export function movementOf(button, shift, control)
{
  if (button === 0 && shift)
  {
    return control ? "zoom" : "pan";
  }
  return [control ? "roll" : "rotate", "pan", "zoom"][button] || null;
}

const MOVEMENTS = {
  rotate(camera, from, to, size) {
    camera.azimuth(-DEGREES_ACROSS * (to[0] - from[0]) / size[0]);
    camera.elevation(-DEGREES_ACROSS * (to[1] - from[1]) / size[1]);
    camera.orthogonalizeViewUp();
  },
  pan(camera, from, to, size) { camera.pan(to[0] - from[0], to[1] - from[1], size); },
  zoom(camera, from, to,
    size) { camera.approach(DOLLY_BASE ** (10 * (to[1] - from[1]) / (size[1] / 2))); },
  roll(camera, from, to, size) {
    const angle = (p) => Math.atan2(p[1] - size[1] / 2, p[0] - size[0] / 2) * 180 / Math.PI;
    camera.roll(angle(to) - angle(from));
    camera.orthogonalizeViewUp();
  },
};

/** Moves a camera as a drag from a point to another does: pixels, y up, of [width, height]. */
export function drag(camera, movement, from, to, size)
{
  MOVEMENTS[movement](camera, from, to, size);
}

/** Two fingers, a pair of points before and after: pan, pinch and twist. */
export function dragTwo(camera, from, to, size)
{
  const middle = (pair) => [(pair[0][0] + pair[1][0]) / 2, (pair[0][1] + pair[1][1]) / 2];
  const arm = (pair) => [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
  const angle = (pair) => Math.atan2(arm(pair)[1], arm(pair)[0]) * 180 / Math.PI;
  const length = (pair) => Math.max(1, Math.hypot(...arm(pair)));
  drag(camera, "pan", middle(from), middle(to), size);
  camera.approach(length(to) / length(from));
  camera.roll(angle(to) - angle(from));
  camera.orthogonalizeViewUp();
}

/** The factor of a wheel: 1.21 for a notch; a pinch on a touch pad is a wheel with Control. */
export function wheelFactor(event)
{
  const pixels = event.deltaY * [1, 33, 800][event.deltaMode];
  const notches = -pixels / (event.ctrlKey ? 20 : 100);
  return DOLLY_BASE ** (2 * Math.max(-3, Math.min(3, notches)));
}

/**
 * Moves viewer.camera, and calls viewer.moved(), by the events of a canvas. A click or a tap calls
 * onpick(x, y): where it was, in device pixels, y down.
 */
export class Pointer
{
  constructor(element, viewer, onpick)
  {
    this.element = element;
    this.viewer = viewer;
    this.onpick = onpick;
    this.points = new Map(); // of the pointers that are down
    this.start = null;       // of a click
    this.two = null;         // where two fingers began, with the camera of then
    this.movement = null;
    this.listeners = new AbortController();
    element.style.touchAction = "none";
    const on = (type, react) => element.addEventListener(
      type, (event) => react.call(this, event), {passive: false, signal: this.listeners.signal});
    on("pointerdown", this.press);
    on("pointermove", this.move);
    on("pointerup", this.lift);
    on("pointercancel", this.cancel);
    on("wheel", this.wheel);
    // Not pointerdown: Firefox would not tell of a second finger.
    on("mousedown", (event) => event.preventDefault());
    on("contextmenu", (event) => event.preventDefault());
  }

  release() { this.listeners.abort(); }

  get size()
  {
    const box = this.element.getBoundingClientRect();
    return [box.width, box.height];
  }

  pointOf(event)
  {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, box.bottom - event.clientY];
  }

  press(event)
  {
    this.element.focus({preventScroll: true});
    if (this.points.size >= 2)
    {
      return;
    }
    this.element.setPointerCapture(event.pointerId);
    const point = this.pointOf(event);
    this.start = this.points.size === 0 ? point : null;
    this.points.set(event.pointerId, point);
    this.movement = movementOf(event.button, event.shiftKey, event.ctrlKey);
    this.two = this.points.size === 2 && {
      points: [...this.points.values()],
      camera: this.viewer.camera.copy(),
    };
  }

  isClick(event, point)
  {
    const most = event.pointerType === "mouse" ? CLICK_PIXELS : TAP_PIXELS;
    return this.start !== null &&
           Math.hypot(point[0] - this.start[0], point[1] - this.start[1]) <= most;
  }

  move(event)
  {
    const {camera} = this.viewer;
    const before = this.points.get(event.pointerId);
    const point = this.pointOf(event);
    if (!before || this.isClick(event, point))
    {
      return;
    }
    this.start = null;
    this.points.set(event.pointerId, point);
    if (this.points.size === 2)
    {
      camera.assign(this.two.camera);
      dragTwo(camera, this.two.points, [...this.points.values()], this.size);
    }
    else if (this.movement)
    {
      drag(camera, this.movement, before, point, this.size);
    }
    this.viewer.moved();
  }

  lift(event)
  {
    const point = this.pointOf(event);
    if (this.points.has(event.pointerId) && event.button === 0 && this.isClick(event, point))
    {
      const [width, height] = this.size;
      const {element} = this;
      this.onpick(point[0] * element.width / width, (height - point[1]) * element.height / height);
    }
    this.cancel(event);
  }

  cancel(event)
  {
    this.points.delete(event.pointerId);
    this.start = null;
    this.movement = this.points.size > 0 ? "rotate" : null;
  }

  wheel(event)
  {
    event.preventDefault();
    this.viewer.camera.approach(wheelFactor(event));
    this.viewer.moved();
  }
}
