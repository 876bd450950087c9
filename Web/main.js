// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the scene of the page and shows it. The mode is "all"; "canvas": the picture alone, with
// its camera; or "bare", by #bare: likewise, and the document's title is "ready" when it is
// complete.
import {Archive, readScene} from "./archive.js";
import {Controls} from "./controls.js";
import {byId} from "./elements.js";
import {Framing} from "./framing.js";
import {Keys} from "./keys.js";
import {Picked} from "./picked.js";
import {Pointer} from "./pointer.js";
import {Viewer} from "./viewer.js";

const GREATEST_RATIO = 2; // a frame takes as long as it has pixels

function showMessage(title, text)
{
  byId("message-title").textContent = title;
  byId("message-text").textContent = text;
  byId("message").hidden = false;
}

function hideMessage()
{
  byId("message").hidden = true;
}

const isBare = () => location.hash === "#bare";

function modeOf(scene)
{
  return isBare() ? "bare" : scene.controls === "none" ? "canvas" : "all";
}

function fail(title, text)
{
  byId("loading").hidden = true;
  showMessage(title, text);
  if (isBare())
  {
    document.title = "failed";
  }
}

function setMode(mode)
{
  document.documentElement.dataset.mode = mode;
}

/** A lost context is reported, and comes back by itself. */
function watchContext(canvas)
{
  canvas.addEventListener("webglcontextlost",
    () => showMessage("The graphics card was reset",
      "The browser lost its connection to it. The picture returns as soon as it is back."));
  canvas.addEventListener("webglcontextrestored", hideMessage);
}

/** Until the first frame, "Loading" is shown: while shaders are compiled without a share. */
async function load(viewer)
{
  byId("loading").hidden = false;
  await viewer.load((share) => { byId("progress").value = share; });
  byId("progress").removeAttribute("value");
}

/** Connects the canvas and the controls of the mode; returns what is to be called after a frame. */
function connect(viewer, scene, mode)
{
  const {canvas} = viewer;
  const ratio = mode === "bare" ? Infinity : GREATEST_RATIO;
  const framing = new Framing(viewer, canvas, scene.size, ratio);
  new Keys(canvas, viewer);
  if (mode !== "all")
  {
    new Pointer(canvas, viewer, () => {});
    return () => {};
  }
  const picked = new Picked(viewer, () => scene.steps[viewer.step].volumes.map(({name}) => name));
  const controls = new Controls(viewer, scene, () => framing.reset());
  new Pointer(canvas, viewer, (x, y) => picked.pick(x, y));
  return (report) => {
    controls.showFrame(report);
    picked.follow();
  };
}

async function drawFirst(viewer, mode)
{
  viewer.draw();
  if (mode !== "bare")
  {
    viewer.moved(); // a coarse frame comes first
  }
  await viewer.complete;
  if (mode === "bare")
  {
    document.title = "ready";
  }
}

async function start()
{
  const scene = readScene();
  const mode = modeOf(scene);
  setMode(mode === "all" ? "canvas" : mode);
  const canvas = byId("picture");
  const viewer = new Viewer(canvas, scene, new Archive(scene));
  canvas.viewer = viewer; // for scripts, such as tests
  viewer.onerror = (text) => fail("The picture can't be drawn", text);
  watchContext(canvas);
  await load(viewer);
  setMode(mode);
  const noteFrame = connect(viewer, scene, mode);
  viewer.onframe = (report) => {
    byId("loading").hidden = true;
    noteFrame(report);
  };
  await drawFirst(viewer, mode);
}

byId("message-close").addEventListener("click", hideMessage);
window.addEventListener("hashchange", () => location.reload());
start().catch((error) => {
  setMode("canvas");
  fail("The scene can't be shown", error.message);
});
