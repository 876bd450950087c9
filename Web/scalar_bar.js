// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// A bar beside the picture: which colour is which value.
import {colorAt, cssColor} from "./color_maps.js";
import {makeSvg, shortNumber} from "./elements.js";
import {makeLogTicks, makeTicks} from "./ticks.js";

// In units of 1/15 of the page's font, which is larger on large screens.
const FONT = 15;
const BAR = {
  left: 10,
  top: 32,
  width: 16,
  below: 12,
  steps: 128,
};

function titleLines(title, letters)
{
  const short = title.length > 2 * letters ? `${title.slice(0, 2 * letters - 1)}…` : title;
  return [short.slice(0, letters), short.slice(letters)].filter((line) => line.length > 0);
}

/** The width that the texts need; a letter of the font is about 7 units wide. */
function widthOf(lines, ticks)
{
  const longest = (texts) => Math.max(0, ...texts.map((text) => text.length));
  const labels = BAR.left + BAR.width + 14 + 7 * longest(ticks.map((tick) => shortNumber(tick)));
  return Math.max(labels, BAR.left + 6 + 7 * longest(lines));
}

export class ScalarBar
{
  constructor(svg)
  {
    this.svg = svg;
    this.title = svg.querySelector("title");
    this.parts = makeSvg("g", {}, svg);
    new ResizeObserver(() => this.draw()).observe(svg);
  }

  /** what: { title, color: [[x, r, g, b]...], range, logarithmic }, or null: no bar. */
  show(what)
  {
    this.what = what;
    this.svg.toggleAttribute("hidden", !what);
    this.draw();
  }

  draw()
  {
    const unit = parseFloat(getComputedStyle(this.svg).fontSize) / FONT;
    const height = this.svg.clientHeight / unit;
    if (!this.what || height === 0)
    {
      return;
    }
    const barHeight = height - BAR.top - BAR.below;
    const ticks = this.ticks(barHeight);
    const lines = titleLines(this.what.title, 12);
    const width = widthOf(lines, ticks);
    this.svg.style.width = `${width / FONT}em`;
    this.parts.setAttribute("transform", `scale(${unit})`);
    this.title.textContent = `Colours of ${this.what.title}`;
    this.parts.replaceChildren();
    makeSvg("rect", {width, height, rx: 8, class: "back"}, this.parts);
    lines.forEach((line, i) => this.text(line, BAR.left, 13 + 13 * i));
    this.drawColors(barHeight);
    this.drawTicks(ticks, barHeight);
  }

  /** The value at a share of the bar's height, and the other way round. */
  valueAt(share)
  {
    const [low, high] = this.what.range;
    return this.what.logarithmic ? low * (high / low) ** share : low + share * (high - low);
  }

  shareOf(value)
  {
    const [low, high] = this.what.range;
    return this.what.logarithmic ? Math.log(value / low) / Math.log(high / low)
                                 : (value - low) / (high - low);
  }

  drawColors(barHeight)
  {
    const step = barHeight / BAR.steps;
    for (let i = 0; i < BAR.steps; ++i)
    {
      const color = colorAt(this.what.color, this.valueAt(1 - (i + 0.5) / BAR.steps));
      makeSvg("rect", {
        x: BAR.left,
        y: BAR.top + i * step,
        width: BAR.width,
        height: step + (i + 1 < BAR.steps ? 0.5 : 0),
        fill: cssColor(color),
      },
        this.parts);
    }
  }

  ticks(barHeight)
  {
    const {range, logarithmic} = this.what;
    const most = Math.max(2, Math.floor(barHeight / 32));
    return logarithmic ? makeLogTicks(...range) : makeTicks(...range, most);
  }

  drawTicks(ticks, barHeight)
  {
    const x1 = BAR.left + BAR.width;
    for (const tick of ticks)
    {
      const y = BAR.top + barHeight * (1 - this.shareOf(tick));
      makeSvg("line", {x1, x2: x1 + 4, y1: y, y2: y, class: "line"}, this.parts);
      this.text(shortNumber(tick), x1 + 8, y + 4);
    }
  }

  text(words, x, y) { makeSvg("text", {x, y, "font-size": 12}, this.parts).textContent = words; }
}
