// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a click on the picture hit: cell, position and value.
import {byId, shortNumber} from "./elements.js";

/** Rows [name, text] of viewer.pick()'s answer; several: whether the scene has several volumes. */
export function describePick({volume, cell, position, value}, names)
{
  const rows = [["Value", shortNumber(value, 7)]];
  if (cell !== null && cell !== undefined)
  {
    rows.push(["Cell", String(cell)]);
  }
  rows.push(["Position", position.map((x) => shortNumber(x, 6)).join(", ")]);
  if (names.length > 1)
  {
    rows.push(["Volume", names[volume]]);
  }
  return rows;
}

export class Picked
{
  /** names(): of the volumes. */
  constructor(viewer, names)
  {
    this.viewer = viewer;
    this.names = names;
    this.plate = byId("picked");
    this.canvas = byId("picture");
    byId("picked-close").addEventListener("click", () => this.hide());
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  hide()
  {
    this.plate.hidden = true;
    this.canvas.focus({preventScroll: true});
  }

  /** P picks in the middle of the picture. */
  key(event)
  {
    if (event.key.toLowerCase() === "p" && !event.ctrlKey && !event.metaKey && !event.altKey)
    {
      event.preventDefault();
      this.pick(this.canvas.width / 2, this.canvas.height / 2);
    }
    else if (event.key === "Escape")
    {
      this.hide();
    }
  }

  /** x and y in device pixels, y down. */
  async pick(x, y)
  {
    const hit = await this.viewer.pick(x, y);
    this.plate.hidden = !hit;
    if (hit)
    {
      byId("picked-list").replaceChildren();
      for (const [name, text] of describePick(hit, this.names()))
      {
        byId("picked-list").append(makeCell("dt", name), makeCell("dd", text));
      }
      this.place(x, y);
    }
  }

  /** Beside the point, within the picture. */
  place(x, y)
  {
    const scale = this.canvas.clientWidth / this.canvas.width;
    const within = (wish, own, all) => Math.max(8, Math.min(wish, all - own - 8));
    const {clientWidth, clientHeight} = this.canvas;
    const left = within(x * scale + 14, this.plate.offsetWidth, clientWidth);
    const top = within(y * scale + 14, this.plate.offsetHeight, clientHeight);
    this.plate.style.left = `${left}px`;
    this.plate.style.top = `${top}px`;
  }
}

function makeCell(tag, text)
{
  const cell = document.createElement(tag);
  cell.textContent = text;
  return cell;
}
