// Colours that people with any kind of colour vision can tell apart, one for each joint, as in cosim/plot.
const kJointColors = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9'];
const kLimitColor = 'rgba(207, 34, 46, 0.10)';  // as .marks .pink in page.css
const kViolationColor = 'rgba(207, 34, 46, 0.35)';
const kStepColor = '#8c959f';
const kCursorColor = '#cf222e';
const kStateColors = {
  idle: '#d0d7de', moving: '#54aeff', stopping: '#d4a72c', holding: '#c297ff', fault: '#ff8182',
};
const darkRoom = window.matchMedia('(prefers-color-scheme: dark)');
// A colour of page.css, which differs in a dark room.
const pageColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
