// Builds the elements of the page. Texts of users are only ever set as `textContent`, so that nothing in them can run.
function element(parent, name, className) {
  const made = document.createElement(name);
  if (className) made.className = className;
  parent.appendChild(made);
  return made;
}

function row(table, cells, kind) {
  const line = element(table, 'tr');
  for (const cell of cells) element(line, kind || 'td').textContent = cell;
  return line;
}

// A value that all listeners share: which joints are shown.
class Selection {
  constructor(count) {
    this.joints = new Array(count).fill(true);
    this.listeners = [];
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  // A click shows the joint alone; another click on it shows all; with shift the joint is added or removed.
  choose(joint, more) {
    const alone = this.joints.every((shown, i) => shown === (i === joint));
    if (more) this.joints[joint] = !this.joints[joint];
    else this.joints = this.joints.map((_, i) => alone || i === joint);
    for (const listener of this.listeners) listener();
  }
}
