// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The size of the canvas. If it is narrower than the picture, it shows the picture's full width.

/** How much more than the picture's height a canvas shows. */
export function heightFactor(pictureSize, canvasSize)
{
  const aspect = ([width, height]) => width / height;
  return Math.max(1, aspect(pictureSize) / aspect(canvasSize));
}

/** Makes the camera see a multiple of the height. */
export function widenCamera(camera, factor)
{
  const halfAngle = camera.viewAngle * Math.PI / 360;
  camera.viewAngle = Math.atan(factor * Math.tan(halfAngle)) * 360 / Math.PI;
  camera.parallelScale *= factor;
}

export class Framing
{
  /** greatestRatio: most device pixels along a pixel of the page. */
  constructor(viewer, canvas, pictureSize, greatestRatio)
  {
    this.viewer = viewer;
    this.canvas = canvas;
    this.pictureSize = pictureSize;
    this.greatestRatio = greatestRatio;
    this.factor = 1;
    this.written = viewer.camera.copy();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas);
    this.resize();
  }

  resize()
  {
    const ratio = Math.min(window.devicePixelRatio || 1, this.greatestRatio);
    const {clientWidth, clientHeight} = this.canvas;
    const size =
      [clientWidth, clientHeight].map((pixels) => Math.max(1, Math.round(pixels * ratio)));
    this.widen(heightFactor(this.pictureSize, size));
    this.viewer.resize(...size);
  }

  widen(factor)
  {
    if (factor !== this.factor)
    {
      widenCamera(this.viewer.camera, factor / this.factor);
      this.factor = factor;
    }
  }

  /** Returns to the view of the picture. */
  reset()
  {
    const {factor} = this;
    this.viewer.camera.assign(this.written);
    this.factor = 1;
    this.widen(factor);
    this.viewer.draw();
  }
}
