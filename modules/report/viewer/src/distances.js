// Distances between surfaces, as bytes.

/** The signed value that a byte stands for, as a share of `max`: the inverse of `packed_value`. */
export function shareOfMax(byte, {usual, max}) {
  const step = byte & 127;
  let value = usual * step / 100;
  if (step > 100) value = usual > 0 ? usual * (max / usual) ** ((step - 100) / 27) : max * (step - 100) / 27;
  return max > 0 ? Math.min(1, value / max) * (byte < 128 ? 1 : -1) : 0;
}
