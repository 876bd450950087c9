// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of the panel with the transfer functions of a volume: opacities, colours, histogram.
import {COLOR_MAP_NAMES} from "./color_maps.js";
import {Editor} from "./editor.js";
import {byId, makeOption, shortNumber} from "./elements.js";
import {chartRange, chosenColors, groupVolumes, trimColors, WRITTEN} from "./function_choices.js";
import {countValues} from "./histogram.js";
import {endsOf, simplifyPoints} from "./opacity_points.js";

const SEVERAL_COMPONENTS = ["INDEPENDENT", "COLOR_AND_OPACITY", "DIRECT_COLOR"];
const MOST_POINTS = 40;     // that are told apart in the chart
const TOLERANCE = 1 / 1024; // of an opacity, where a function has more points

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
    byId("color-map").append(...[WRITTEN, ...COLOR_MAP_NAMES].map((name) => makeOption(name)));
    const groups = groupVolumes(volumes());
    byId("volume").append(...groups.map(({name}, i) => makeOption(i, name || `${i + 1}`)));
    byId("volume-row").hidden = groups.length < 2;
    byId("functions").hidden = groups.length === 0;
    this.listen();
    this.show();
  }

  /** The shown volume, which may have several blocks. */
  get group() { return groupVolumes(this.volumes())[this.index]; }

  /** Whether it has functions that can be edited: those of one component. */
  get editable()
  {
    const [first] = this.group ? this.group.indices : [];
    const volume = this.volumes()[first];
    return Boolean(volume) && !volume.features.some((name) => SEVERAL_COMPONENTS.includes(name));
  }

  listen()
  {
    const on = (id, type, react) => byId(id).addEventListener(type, react);
    on("volume", "change", () => {
      this.index = Number(byId("volume").value);
      this.show();
    });
    ["point-value", "point-opacity"].forEach(
      (id, part) => on(id, "change", () => this.movePoint(part, byId(id).valueAsNumber)));
    on("point-add", "click", () => this.editor.add());
    on("point-remove", "click", () => this.editor.remove());
    on("functions-reset", "click", () => this.reset());
    on("color-map", "change", () => this.change({map: byId("color-map").value}));
    on("color-reversed", "change", () => this.change({reversed: byId("color-reversed").checked}));
    ["color-low", "color-high"].forEach(
      (id, end) => on(id, "change", () => this.changeRange(end, byId(id))));
  }

  get state()
  {
    const {index, states} = this;
    states[index] = states[index] || this.writtenState();
    return states[index];
  }

  writtenState()
  {
    const written = {...this.viewer.functions(this.group.indices[0])};
    written.color = trimColors(written.color);
    if (written.opacity.length > MOST_POINTS)
    {
      written.opacity = simplifyPoints(written.opacity, TOLERANCE);
    }
    const range = endsOf(written.color);
    return {written, opacity: written.opacity, map: WRITTEN, reversed: false, range};
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
    if (!this.editable)
    {
      return null;
    }
    const {color} = this.functions;
    const [low, high] = endsOf(color);
    return {
      title: this.group.name,
      color,
      range: high > low ? [low, high] : chartRange([low, high], this.functions)
    };
  }

  /** Shows everything anew, with the histogram of the present time step. */
  show()
  {
    byId("function-parts").hidden = !this.editable;
    byId("function-note").hidden = this.editable;
    if (this.editable)
    {
      const {indices, range} = this.group;
      const volumes = this.volumes();
      const parts =
        indices.map((i) => ({scalars: this.viewer.scalars(i), range: volumes[i].range}));
      this.counts = countValues(parts, range);
      this.showState();
    }
    this.onChange();
  }

  showState()
  {
    const {functions, group, state, counts} = this;
    const range = chartRange(group.range, functions);
    this.editor.show({...functions, range, counts, countsRange: group.range});
    byId("color-map").value = state.map;
    byId("color-reversed").checked = state.reversed;
    ["color-low", "color-high"].forEach((id, end) => {
      byId(id).value = shortNumber(state.range[end]);
      byId(id).setCustomValidity("");
    });
  }

  showPoint(index, points)
  {
    byId("point-value").value = shortNumber(points[index][0]);
    byId("point-opacity").value = shortNumber(points[index][1]);
    byId("point-remove").disabled = points.length < 2;
  }

  /** part: 0 for the value of the chosen point, 1 for its opacity; what isn't typed stays exact. */
  movePoint(part, number)
  {
    const {editor} = this;
    const to = [...editor.points[editor.chosen]];
    if (Number.isFinite(number))
    {
      to[part] = number;
      editor.move(to);
    }
    this.showPoint(editor.chosen, editor.points);
  }

  /** end: 0 for the value of the first colour, 1 for that of the last. */
  changeRange(end, input)
  {
    const range = [...this.state.range];
    range[end] = input.valueAsNumber;
    if (range[0] < range[1])
    {
      this.change({range});
      return;
    }
    input.setCustomValidity("The value on the left must be below the one on the right.");
    input.reportValidity();
  }

  reset()
  {
    const {written} = this.state;
    this.change({
      opacity: written.opacity,
      map: WRITTEN,
      reversed: false,
      range: endsOf(written.color),
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
      this.draw();
    });
  }

  draw()
  {
    for (const index of this.group.indices)
    {
      this.viewer.setFunctions(index, this.functions);
    }
    this.viewer.moved(); // a coarse frame comes first
    this.onChange();
  }
}
