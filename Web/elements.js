// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Elements of the page: found by their id, made with attributes, texts of numbers.

/**
 * @param {string} id
 * @returns {any} An element of the kind that page.html says.
 */
export function byId(id)
{
  return document.getElementById(id);
}

export function makeSvg(name, attributes, parent)
{
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  setAttributes(element, attributes);
  parent.append(element);
  return element;
}

export function setAttributes(element, attributes)
{
  for (const [name, value] of Object.entries(attributes))
  {
    element.setAttribute(name, value);
  }
}

export function makeOption(value, text = value)
{
  const option = document.createElement("option");
  option.value = value;
  option.textContent = text;
  return option;
}

/** A number with few digits, for reading. */
export function shortNumber(value, digits = 5)
{
  const short = Number(value.toPrecision(digits));
  return Math.abs(short) < 1e-3 && short !== 0 ? short.toExponential() : String(short);
}

let sayTimer = 0;

/** Says something beside the buttons, also to a screen reader, and takes it back after a while. */
export function say(text)
{
  const status = byId("status");
  status.textContent = text;
  clearTimeout(sayTimer);
  sayTimer = setTimeout(() => { status.textContent = ""; }, 6000);
}
