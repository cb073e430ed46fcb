// Columns of numbers, as cosim/page/column_code.cpp writes them: differences of some order as variable-length integers,
// in base64. The values are exact.

// The integers of a column, in units of 10^-digits.
function decodeIntegers(column) {
  const bytes = atob(column.data);
  const values = new Float64Array(column.rows);
  let at = 0;
  for (let row = 0; row < column.rows; row += 1) {
    let code = 0;
    let weight = 1;
    let byte;
    do {
      byte = bytes.charCodeAt(at);
      at += 1;
      code += (byte & 127) * weight;
      weight *= 128;
    } while (byte & 128);
    values[row] = code % 2 === 0 ? code / 2 : -(code + 1) / 2;
  }
  for (let order = 0; order < column.order; order += 1) {
    for (let row = 1; row < column.rows; row += 1) values[row] += values[row - 1];
  }
  return values;
}

// The numbers of a column in its unit.
function decodeColumn(column) {
  const values = decodeIntegers(column);
  const scale = 10 ** column.digits;
  if (scale !== 1) for (let row = 0; row < values.length; row += 1) values[row] /= scale;
  return values;
}
