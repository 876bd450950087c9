// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The chart of an opacity function over the histogram: points are dragged by mouse, touch and keys.
import {colorAt, cssColor} from "./color_maps.js";
import {makeSvg, setAttributes, shortNumber} from "./elements.js";
import {histogramPath} from "./histogram.js";
import {addPoint, movePoint, removePoint, splitAfter} from "./opacity_points.js";
import {makeTicks} from "./ticks.js";

// In units of the chart's viewBox, which is 320 x 166.
const CHART = {
  left: 8,
  right: 312,
  top: 8,
  bottom: 122,
  height: 114
};
const COLORS = {
  top: 128,
  height: 14,
  steps: 152
};
const REACH = {
  mouse: 10,
  pen: 12,
  touch: 24
};                     // of a point
const KEY_STEP = 0.01; // of the chart's width or height

export class Editor
{
  /** onChange(points): after each edit. onChoose(index, points): the chosen point. */
  constructor(svg, onChange, onChoose)
  {
    this.svg = svg;
    this.onChange = onChange;
    this.onChoose = onChoose;
    this.chosen = 0;
    this.gradient = makeSvg("linearGradient", {id: "editor-colors"}, makeSvg("defs", {}, svg));
    const width = CHART.right - CHART.left;
    const place = {x: CHART.left, width};
    makeSvg("rect", {...place, y: CHART.top, height: CHART.height, class: "frame"}, svg);
    this.bars = makeSvg("path", {class: "bars"}, svg);
    this.area = makeSvg("path", {fill: "url(#editor-colors)", opacity: 0.45}, svg);
    this.curve = makeSvg("path", {class: "curve"}, svg);
    makeSvg(
      "rect", {...place, y: COLORS.top, height: COLORS.height, fill: "url(#editor-colors)"}, svg);
    this.labels = makeSvg("g", {}, svg);
    this.circles = makeSvg("g", {}, svg);
    svg.addEventListener("pointerdown", (event) => this.press(event));
    svg.addEventListener("pointermove", (event) => this.drag(event));
    svg.addEventListener("lostpointercapture", () => { this.dragged = false; });
    svg.addEventListener("dblclick", (event) => this.removeAt(event));
    svg.addEventListener("keydown", (event) => this.key(event));
  }

  /** range: of the values; counts: of the histogram over its own range. */
  show({color, opacity, range, counts, countsRange})
  {
    this.color = color;
    this.points = opacity;
    this.range = range;
    this.chosen = Math.min(this.chosen, opacity.length - 1);
    const [left, right] = countsRange.map((value) => this.xOf(value));
    this.bars.setAttribute("d", histogramPath(counts, {...CHART, left, right}));
    this.drawColors();
    this.drawLabels();
    this.drawPoints();
  }

  xOf(value)
  {
    const [low, high] = this.range;
    return CHART.left + (CHART.right - CHART.left) * (value - low) / (high - low);
  }

  yOf(opacity) { return CHART.bottom - CHART.height * Math.min(Math.max(opacity, 0), 1); }

  drawColors()
  {
    this.gradient.replaceChildren();
    for (let i = 0; i <= COLORS.steps; ++i)
    {
      const share = i / COLORS.steps;
      const value = this.range[0] + share * (this.range[1] - this.range[0]);
      const color = cssColor(colorAt(this.color, value));
      makeSvg("stop", {offset: share, "stop-color": color}, this.gradient);
    }
  }

  drawLabels()
  {
    this.labels.replaceChildren();
    for (const tick of makeTicks(...this.range, 5))
    {
      const x = Math.min(Math.max(this.xOf(tick), CHART.left + 8), CHART.right - 8);
      const label = makeSvg("text", {x, y: 158, "text-anchor": "middle"}, this.labels);
      label.textContent = shortNumber(tick);
    }
  }

  drawPoints()
  {
    const corners = this.points.map(([x, a]) => `${this.xOf(x)},${this.yOf(a)}`);
    const [first, last] = [this.points[0], this.points[this.points.length - 1]];
    const line = `M${CHART.left},${this.yOf(first[1])}L${corners.join("L")}L${CHART.right},` +
                 this.yOf(last[1]);
    this.curve.setAttribute("d", line);
    this.area.setAttribute("d", `${line}V${CHART.bottom}H${CHART.left}Z`);
    this.matchCircles();
    this.points.forEach(([x, a], i) => {
      const circle = this.circles.children[i];
      const chosen = i === this.chosen;
      const text = `opacity ${shortNumber(a, 3)} of value ${shortNumber(x)}`;
      setAttributes(circle, {
        cx: this.xOf(x),
        cy: this.yOf(a),
        class: chosen ? "chosen" : "",
        tabindex: chosen ? 0 : -1,
        "aria-label": `Point ${i + 1} of ${this.points.length}`,
        "aria-valuenow": a,
        "aria-valuetext": text,
      });
    });
    this.onChoose(this.chosen, this.points);
  }

  matchCircles()
  {
    const {circles} = this;
    while (circles.children.length > this.points.length)
    {
      circles.lastChild.remove();
    }
    while (circles.children.length < this.points.length)
    {
      const range = {"aria-valuemin": 0, "aria-valuemax": 1};
      makeSvg("circle", {r: 6, role: "slider", ...range}, circles);
    }
  }

  edit(points, chosen = this.chosen)
  {
    this.points = points;
    this.chosen = Math.min(Math.max(chosen, 0), points.length - 1);
    this.drawPoints();
    this.onChange(points);
  }

  choose(index)
  {
    this.chosen = Math.min(Math.max(index, 0), this.points.length - 1);
    this.drawPoints();
    this.circles.children[this.chosen].focus();
  }

  move(to) { this.edit(movePoint(this.points, this.chosen, to, this.range)); }

  add()
  {
    const {points, index} = splitAfter(this.points, this.chosen);
    this.edit(points, index);
  }

  remove() { this.edit(removePoint(this.points, this.chosen)); }

  /** Where an event is in the chart: in its units, and as [value, opacity]. */
  locate(event)
  {
    const box = this.svg.getBoundingClientRect();
    const unit = box.width / 320;
    const [x, y] = [(event.clientX - box.left) / unit, (event.clientY - box.top) / unit];
    const share = (x - CHART.left) / (CHART.right - CHART.left);
    const [low, high] = this.range;
    const value = Math.min(Math.max(low + share * (high - low), low), high);
    return {x, y, point: [value, (CHART.bottom - y) / CHART.height]};
  }

  /** The point within reach, or -1. */
  findPoint(event)
  {
    const {x, y} = this.locate(event);
    const far = this.points.map(([value, a]) => Math.hypot(this.xOf(value) - x, this.yOf(a) - y));
    const nearest = far.indexOf(Math.min(...far));
    return far[nearest] <= (REACH[event.pointerType] || REACH.mouse) ? nearest : -1;
  }

  press(event)
  {
    if (event.button !== 0 || !this.points)
    {
      return;
    }
    event.preventDefault();
    let index = this.findPoint(event);
    if (index < 0)
    {
      const {y, point} = this.locate(event);
      if (y > CHART.bottom + 4)
      {
        return;
      }
      const added = addPoint(this.points, point);
      index = added.index;
      this.edit(added.points, index);
    }
    this.choose(index);
    this.dragged = true;
    this.svg.setPointerCapture(event.pointerId);
  }

  drag(event)
  {
    if (this.dragged)
    {
      this.move(this.locate(event).point);
    }
  }

  removeAt(event)
  {
    const index = this.findPoint(event);
    if (index >= 0)
    {
      this.edit(removePoint(this.points, index), index - 1);
    }
  }

  key(event)
  {
    const step = event.shiftKey ? 5 * KEY_STEP : KEY_STEP;
    const dx = step * (this.range[1] - this.range[0]);
    const [x, a] = this.points[this.chosen];
    const last = this.points.length - 1;
    const actions = {
      ArrowLeft: () => this.move([x - dx, a]),
      ArrowRight: () => this.move([x + dx, a]),
      ArrowUp: () => this.move([x, a + step]),
      ArrowDown: () => this.move([x, a - step]),
      PageUp: () => this.choose(this.chosen - 1),
      PageDown: () => this.choose(this.chosen + 1),
      Home: () => this.choose(0),
      End: () => this.choose(last),
      Insert: () => this.add(),
      Delete: () => this.remove(),
      Backspace: () => this.remove(),
    };
    if (actions[event.key] && !event.ctrlKey && !event.altKey && !event.metaKey)
    {
      event.preventDefault();
      actions[event.key]();
      this.circles.children[this.chosen].focus();
    }
  }
}
