// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The directions of the world's axes, in a corner of the picture.

const AXIS_COLORS = ["#e5484d", "#3fb24f", "#4d8dff"];
const ARM = 0.34; // of the size

/**
 * Ends of the axes on the picture, x to the right and y down, and how near each is to the viewer.
 */
export function projectAxes({right, up, back})
{
  return [0, 1, 2].map((axis) => ({axis, x: right[axis], y: -up[axis], nearness: back[axis]}));
}

/** Draws them on a canvas; those behind first. */
export function drawAxes(canvas, camera)
{
  const size = canvas.clientWidth;
  const scale = window.devicePixelRatio || 1;
  canvas.width = canvas.height = Math.round(size * scale);
  const context = canvas.getContext("2d");
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.translate(size / 2, size / 2);
  context.font = `bold ${0.15 * size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineCap = "round";
  const ends = projectAxes(camera.axes()).sort((a, b) => a.nearness - b.nearness);
  for (const {axis, x, y} of ends)
  {
    drawAxis(context, axis, [ARM * size * x, ARM * size * y], size);
  }
}

function drawAxis(context, axis, [x, y], size)
{
  const drawArm = (color, width) => {
    context.strokeStyle = color;
    context.lineWidth = width * size;
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(x, y);
    context.stroke();
  };
  drawArm("rgb(0 0 0 / 55%)", 0.056); // a dark rim is seen on light backgrounds
  drawArm(AXIS_COLORS[axis], 0.034);
  const length = Math.hypot(x, y) || 1;
  const label = [x, y].map((part) => part + 0.1 * size * part / length);
  context.strokeStyle = "rgb(0 0 0 / 55%)";
  context.lineWidth = 0.034 * size;
  context.strokeText("XYZ"[axis], ...label);
  context.fillStyle = AXIS_COLORS[axis];
  context.fillText("XYZ"[axis], ...label);
}
