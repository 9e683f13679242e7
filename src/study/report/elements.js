// SPDX-License-Identifier: MIT
// Elements of the page and of the drawing, made by name, attributes and children.

const byId = (id) => document.getElementById(id);
const drawingNamespace = byId("drawing").namespaceURI;

function filledWith(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

function element(name, attributes = {}, ...children) {
  return filledWith(document.createElement(name), attributes, children);
}

function drawn(name, attributes = {}, ...children) {
  return filledWith(document.createElementNS(drawingNamespace, name), attributes, children);
}

function option(value, text, selected = false) {
  return element("option", { value, selected }, text);
}
