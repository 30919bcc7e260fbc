
/// As in engine/colour/doppler_colour.cpp: nine rows of 1024 texels, over ln D from −1.5 to 1.5.
vec4 colourTexel(int table, int row, float bodyToHead) {
  float along = clamp(0.5 + 0.5 * log(bodyToHead) / 1.5, 0.0, 1.0) * 1023.0;
  int left = min(int(along), 1022);
  vec4 a = texelFetch(colourTexels, 1024 * row + left);
  vec4 b = texelFetch(colourTexels, 1024 * row + left + 1);
  return mix(a, b, along - float(left));
}
