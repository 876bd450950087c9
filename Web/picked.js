// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// What a click on the picture hit: cell, position and value.
import {byId, shortNumber} from "./elements.js";
import {multiply, transformPoint} from "./matrices.js";

/** Rows [name, text] of viewer.pick()'s answer; names: of the volumes. */
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

/** The pixel, y down, where a camera sees a point of the world; null: behind it. */
export function placeOf(camera, position, size)
{
  const [width, height] = size;
  const toClip = multiply(camera.projectionMatrix(width / height), camera.viewMatrix());
  const [x, y, , w] = transformPoint(toClip, position);
  return w > 0 ? [width * (1 + x / w) / 2, height * (1 - y / w) / 2] : null;
}

export class Picked
{
  /** names(): of the volumes. */
  constructor(viewer, names)
  {
    this.viewer = viewer;
    this.names = names;
    this.plate = byId("picked");
    this.mark = byId("picked-mark");
    this.hit = null;
    this.canvas = byId("picture");
    byId("picked-close").addEventListener("click", () => this.hide());
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  hide()
  {
    this.hit = null;
    this.follow();
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
    this.hit = await this.viewer.pick(x, y) || null;
    this.step = this.viewer.step;
    byId("picked-list").replaceChildren();
    for (const [name, text] of this.hit ? describePick(this.hit, this.names()) : [])
    {
      byId("picked-list").append(makeCell("dt", name), makeCell("dd", text));
    }
    this.follow();
  }

  /** Shows the plate beside its point, which the camera may have moved; not in other time steps. */
  follow()
  {
    const {canvas, hit, mark, plate, viewer} = this;
    const size = [canvas.clientWidth, canvas.clientHeight];
    const place =
      hit && this.step === viewer.step ? placeOf(viewer.camera, hit.position, size) : null;
    plate.hidden = mark.hidden = !place;
    if (place)
    {
      moveTo(mark, place);
      const room = [plate.offsetWidth, plate.offsetHeight].map((own, k) => size[k] - own - 8);
      moveTo(plate, place.map((at, k) => Math.max(8, Math.min(at + 14, room[k]))));
    }
  }
}

function moveTo(element, place)
{
  [element.style.left, element.style.top] = place.map((at) => `${at}px`);
}

function makeCell(tag, text)
{
  const cell = document.createElement(tag);
  cell.textContent = text;
  return cell;
}
