// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Time steps: a slider below the picture, and play.
import {byId} from "./elements.js";

const LEAST_MILLISECONDS = 150; // of a step

export class TimeBar
{
  constructor(viewer, steps)
  {
    this.viewer = viewer;
    this.steps = steps;
    this.playing = false;
    byId("time").hidden = steps.length < 2;
    byId("step").max = steps.length - 1;
    byId("step").addEventListener("input", () => this.choose(byId("step").valueAsNumber));
    byId("play").addEventListener("click", () => this.toggle());
    byId("time").addEventListener("submit", (event) => event.preventDefault());
    this.showLabel(viewer.step);
  }

  showLabel(index)
  {
    const {label} = this.steps[index];
    byId("step").value = index;
    byId("step").setAttribute("aria-valuetext", label);
    byId("step-label").textContent = label;
  }

  choose(index)
  {
    this.viewer.step = index;
    this.showLabel(index);
  }

  toggle()
  {
    this.playing = !this.playing;
    byId("play").setAttribute("aria-pressed", this.playing);
    if (this.playing)
    {
      this.play();
    }
  }

  /** Each step is shown until its frame is complete, and a while at least. */
  async play()
  {
    const turn = this.turn = {};
    while (this.playing && this.turn === turn)
    {
      const pause = new Promise((resolve) => setTimeout(resolve, LEAST_MILLISECONDS));
      const complete = new Promise((resolve) => { this.frameComplete = resolve; });
      this.choose((this.viewer.step + 1) % this.steps.length);
      await Promise.all([pause, complete]);
    }
  }

  /** To be called when a frame is complete. */
  noteFrame()
  {
    if (this.frameComplete)
    {
      this.frameComplete();
    }
  }
}
