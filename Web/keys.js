// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Keys that move the camera while the picture has the focus.

const STEP_DEGREES = 5;
const STEP_PAN = 0.05; // of the height
const STEP_ZOOM = 1.1;
const ARROWS = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const ZOOMS = {
  "+": STEP_ZOOM,
  "=": STEP_ZOOM,
  "-": 1 / STEP_ZOOM,
  "_": 1 / STEP_ZOOM,
};

/** The keys for a list of help: [keys, what they do]. */
export const KEY_HELP = [
  ["arrows", "rotate"],
  ["Shift + arrows", "pan"],
  ["+ -", "zoom"],
  ["r", "show all"],
  ["x y z", "look along an axis; with Shift from the other side"],
];

/** Moves a camera by a key; returns whether the key is one of these. */
export function moveByKey(camera, key, shift, bounds, aspect)
{
  const axis = "xyz".indexOf(key.toLowerCase());
  if (key in ARROWS)
  {
    moveByArrow(camera, ARROWS[key], shift);
  }
  else if (key in ZOOMS)
  {
    camera.approach(ZOOMS[key]);
  }
  else if (key === "r" || key === "R")
  {
    camera.reset(bounds, aspect);
  }
  else if (key.length === 1 && axis >= 0)
  {
    camera.lookFrom(axis, shift ? -1 : 1, bounds, aspect);
  }
  else
  {
    return false;
  }
  return true;
}

function moveByArrow(camera, [x, y], shift)
{
  if (shift)
  {
    camera.pan(x * STEP_PAN, y * STEP_PAN, [1, 1]);
    return;
  }
  camera.azimuth(-x * STEP_DEGREES);
  camera.elevation(-y * STEP_DEGREES);
  camera.orthogonalizeViewUp();
}

/** Moves viewer.camera in viewer.bounds, and calls viewer.moved(), by the keys of an element. */
export class Keys
{
  constructor(element, viewer)
  {
    this.listeners = new AbortController();
    element.tabIndex = 0;
    element.addEventListener("keydown", (event) => {
      const aspect = element.clientWidth / element.clientHeight;
      const other = event.ctrlKey || event.altKey || event.metaKey;
      if (!other && moveByKey(viewer.camera, event.key, event.shiftKey, viewer.bounds, aspect))
      {
        event.preventDefault();
        viewer.moved();
      }
    }, {signal: this.listeners.signal});
  }

  release() { this.listeners.abort(); }
}
