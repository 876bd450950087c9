// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of the panel with the transfer functions of a volume: opacities, colours, histogram.
import {COLOR_MAP_NAMES, colorMapPoints} from "./color_maps.js";
import {Editor} from "./editor.js";
import {byId, makeOption, shortNumber} from "./elements.js";
import {countScalars} from "./histogram.js";
import {spreadPoints} from "./opacity_points.js";

const AS_WRITTEN = "as written";

const rangeOf = (points) => [points[0][0], points[points.length - 1][0]];

/** All values that a volume or its functions have. */
export function chartRange(volumeRange, {color, opacity})
{
  const ends = [...volumeRange, ...rangeOf(color), ...rangeOf(opacity)];
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  return high > low ? [low, high] : [low - 0.5, high + 0.5];
}

/** The colours that a choice in the panel makes: { map, reversed, range }. */
export function chosenColors(written, {map, reversed, range})
{
  if (map !== AS_WRITTEN)
  {
    return colorMapPoints(map, ...range, reversed);
  }
  const ends = rangeOf(written);
  const points = spreadPoints(written, ends, reversed ? [range[1], range[0]] : range);
  return reversed ? points.reverse() : points;
}

export class FunctionPanel
{
  /** volumes(): of the time step; onChange(): after an edit. */
  constructor(viewer, volumes, onChange)
  {
    this.viewer = viewer;
    this.volumes = volumes;
    this.onChange = onChange;
    this.states = [];
    this.index = 0;
    this.editor = new Editor(byId("editor"), (opacity) => this.change({opacity}),
      (index, points) => this.showPoint(index, points));
    byId("color-map").append(...[AS_WRITTEN, ...COLOR_MAP_NAMES].map((name) => makeOption(name)));
    byId("volume").append(...volumes().map(({name}, i) => makeOption(i, name || `${i + 1}`)));
    byId("volume-row").hidden = volumes().length < 2;
    byId("functions").hidden = volumes().length === 0;
    this.listen();
    this.show();
  }

  listen()
  {
    const on = (id, type, react) => byId(id).addEventListener(type, react);
    on("volume", "change", () => {
      this.index = Number(byId("volume").value);
      this.show();
    });
    on("point-value", "change", () => this.movePoint());
    on("point-opacity", "change", () => this.movePoint());
    on("point-add", "click", () => this.editor.add());
    on("point-remove", "click", () => this.editor.remove());
    on("functions-reset", "click", () => this.reset());
    on("color-map", "change", () => this.change({map: byId("color-map").value}));
    on("color-reversed", "change", () => this.change({reversed: byId("color-reversed").checked}));
    on("color-low", "change", () => this.changeRange());
    on("color-high", "change", () => this.changeRange());
  }

  get state()
  {
    const {index, states} = this;
    states[index] = states[index] || this.writtenState();
    return states[index];
  }

  writtenState()
  {
    const written = this.viewer.functions(this.index);
    const range = rangeOf(written.color);
    return {written, opacity: written.opacity, map: AS_WRITTEN, reversed: false, range};
  }

  /** { color, opacity, nan } of the shown volume. */
  get functions()
  {
    const {written, opacity, ...choice} = this.state;
    return {...written, opacity, color: chosenColors(written.color, choice)};
  }

  /** What the scalar bar shows, or null if there is no volume. */
  get bar()
  {
    const volume = this.volumes()[this.index];
    if (!volume)
    {
      return null;
    }
    const {color} = this.functions;
    const [low, high] = rangeOf(color);
    return {
      title: volume.name,
      color,
      range: high > low ? [low, high] : chartRange([low, high], this.functions)
    };
  }

  /** Shows everything anew, with the histogram of the present time step. */
  show()
  {
    const volume = this.volumes()[this.index];
    if (volume)
    {
      this.counts = countScalars(this.viewer.scalars(this.index));
      this.showState();
    }
    this.onChange();
  }

  showState()
  {
    const volume = this.volumes()[this.index];
    const {functions, state, counts} = this;
    const range = chartRange(volume.range, functions);
    this.editor.show({...functions, range, counts, countsRange: volume.range});
    byId("color-map").value = state.map;
    byId("color-reversed").checked = state.reversed;
    byId("color-low").value = shortNumber(state.range[0], 7);
    byId("color-high").value = shortNumber(state.range[1], 7);
  }

  showPoint(index, points)
  {
    byId("point-value").value = shortNumber(points[index][0], 7);
    byId("point-opacity").value = shortNumber(points[index][1], 7);
    byId("point-remove").disabled = points.length < 2;
  }

  movePoint()
  {
    const to = ["point-value", "point-opacity"].map((id) => byId(id).valueAsNumber);
    if (to.every(Number.isFinite))
    {
      this.editor.move(to);
    }
    this.showPoint(this.editor.chosen, this.editor.points);
  }

  changeRange()
  {
    const range = ["color-low", "color-high"].map((id) => byId(id).valueAsNumber);
    const valid = range.every(Number.isFinite) && range[0] < range[1];
    byId("color-high").setCustomValidity(valid ? "" : "The last value is above the first.");
    if (valid)
    {
      this.change({range});
    }
  }

  reset()
  {
    const {written} = this.state;
    this.change({
      opacity: written.opacity,
      map: AS_WRITTEN,
      reversed: false,
      range: rangeOf(written.color),
    });
  }

  /** Draws at most once a frame of the screen, however fast a point is dragged. */
  change(changes)
  {
    Object.assign(this.state, changes);
    if (!("opacity" in changes) || changes.map)
    {
      this.showState();
    }
    this.pending = this.pending || requestAnimationFrame(() => {
      this.pending = 0;
      this.viewer.setFunctions(this.index, this.functions);
      this.onChange();
    });
  }
}
