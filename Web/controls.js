// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The controls around the picture: accuracy, view, camera, saved pictures.
import {drawAxes} from "./axes.js";
import {cameraCommand, cameraPython} from "./camera_text.js";
import {byId, makeOption, say, shortNumber} from "./elements.js";
import {FunctionPanel} from "./function_panel.js";
import {KEY_HELP} from "./keys.js";
import {ScalarBar} from "./scalar_bar.js";
import {TimeBar} from "./time_bar.js";

export class Controls
{
  /** resetCamera(): returns to the view of the written picture. */
  constructor(viewer, scene, resetCamera)
  {
    this.viewer = viewer;
    this.scene = scene;
    const volumes = () => scene.steps[viewer.step].volumes;
    this.bar = new ScalarBar(byId("scalar-bar"));
    this.functions = new FunctionPanel(viewer, volumes, () => this.showBar());
    this.time = new TimeBar(viewer, scene.steps);
    this.shownStep = viewer.step;
    byId("reset").addEventListener("click", resetCamera);
    this.showTexts();
    this.listenToAccuracy();
    this.listenToButtons();
    this.listenToDirections();
    this.showBar();
  }

  showTexts()
  {
    const {title, omissions, generator} = this.scene;
    byId("title").textContent = title;
    byId("generator").textContent = generator;
    byId("omissions").hidden = omissions.length === 0;
    byId("omissions-count").textContent = `Left out of this page: ${omissions.length}`;
    for (const text of omissions)
    {
      const item = document.createElement("li");
      item.textContent = text;
      byId("omissions-list").append(item);
    }
    for (const [keys, action] of KEY_HELP)
    {
      const row = byId("help").insertRow();
      row.insertCell().textContent = keys;
      row.insertCell().textContent = action;
    }
  }

  listenToAccuracy()
  {
    const {viewer} = this;
    const {name, tolerance} = viewer.level;
    const level = byId("level");
    if (![...level.options].some((option) => option.value === name))
    {
      level.prepend(makeOption(name, name[0].toUpperCase() + name.slice(1)));
    }
    level.value = name;
    this.tolerance = tolerance;
    byId("tolerance").value = shortNumber(tolerance, 4);
    level.addEventListener("change", () => this.changeLevel());
    byId("tolerance").addEventListener("change", () => this.changeTolerance());
    /** @type {NodeListOf<HTMLInputElement>} */
    const radios = document.querySelectorAll("input[name=show]");
    for (const radio of radios)
    {
      radio.checked = radio.value === viewer.show;
      radio.addEventListener("change", () => {
        viewer.show = radio.value;
        this.showBar();
      });
    }
    this.enableTolerance();
  }

  enableTolerance()
  {
    byId("tolerance").disabled =
      !["default", "accurate", "reference"].includes(byId("level").value);
  }

  changeLevel()
  {
    this.enableTolerance();
    this.viewer.level = {name: byId("level").value, tolerance: this.tolerance};
  }

  changeTolerance()
  {
    const input = byId("tolerance");
    if (input.reportValidity())
    {
      this.tolerance = input.valueAsNumber;
      this.changeLevel();
    }
  }

  showBar()
  {
    const errors = this.viewer.show === "error" ? this.viewer.errorLegend : null;
    this.bar.show(errors || (this.functions ? this.functions.bar : null));
  }

  /** After each frame; report: of viewer.onframe. */
  showFrame({complete, milliseconds, lost, refused})
  {
    drawAxes(byId("axes"), this.viewer.camera);
    if (!complete)
    {
      return;
    }
    byId("milliseconds").textContent = `${shortNumber(milliseconds, 3)} ms a frame`;
    const failed = [[lost, "lost"], [refused, "refused"]].filter(([count]) => count > 0);
    byId("frame-note").hidden = failed.length === 0;
    byId("frame-note").textContent =
      `Rays of this frame: ${failed.map((words) => words.join(" ")).join(", ")}.`;
    if (this.shownStep !== this.viewer.step)
    {
      this.shownStep = this.viewer.step;
      this.functions.show();
    }
    else if (this.viewer.show === "error")
    {
      this.showBar();
    }
    this.time.noteFrame();
  }

  listenToButtons()
  {
    byId("save").addEventListener("click", () => this.save());
    const toText = {"copy-command": cameraCommand, "copy-python": cameraPython};
    for (const [id, write] of Object.entries(toText))
    {
      byId(id).addEventListener("click", () => {
        const {width, height} = byId("picture");
        this.copy(write(this.viewer.camera.toObject(), [width, height]));
      });
    }
    byId("panel-toggle").addEventListener("click", () => {
      const panel = byId("panel");
      panel.hidden = !panel.hidden;
      byId("panel-toggle").setAttribute("aria-expanded", !panel.hidden);
    });
    const full = byId("full-screen");
    full.hidden = !document.fullscreenEnabled;
    full.addEventListener("click", () => document.fullscreenElement
                                           ? document.exitFullscreen()
                                           : document.documentElement.requestFullscreen());
  }

  listenToDirections()
  {
    const {viewer} = this;
    for (const button of byId("look-from").querySelectorAll("button"))
    {
      button.addEventListener("click", () => {
        const {axis, sign} = button.dataset;
        const {width, height} = byId("picture");
        viewer.camera.lookFrom(Number(axis), Number(sign), viewer.bounds, width / height);
        viewer.draw();
      });
    }
  }

  async save()
  {
    const url = URL.createObjectURL(await this.viewer.toPng());
    const link = document.createElement("a");
    link.href = url;
    link.download = `${fileName(this.scene.title)}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 60000);
    say(`Saved ${link.download}`);
  }

  /** The text is shown, too: without permission to copy it can be selected. */
  async copy(text)
  {
    const shown = byId("copied");
    shown.hidden = false;
    shown.value = text;
    try
    {
      await navigator.clipboard.writeText(text);
      say("Copied");
    }
    catch (error)
    {
      shown.select();
      say(document.execCommand("copy") ? "Copied" : "Press Ctrl+C to copy the selected text");
    }
  }
}

/** A title as the name of a file. */
export function fileName(title)
{
  const name = title.replace(/[^\p{L}\p{N}._-]+/gu, "_").replace(/^[._]+/, "").slice(0, 80);
  return name || "tetmarch";
}
