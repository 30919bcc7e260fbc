
LegView legAt(int first, int i) {
  int at = 14 * (first + i);
  vec4 a = texelFetch(legTexels, at);
  vec4 b = texelFetch(legTexels, at + 1);
  LegView leg;
  leg.eye = a.xyz;
  leg.distance = a.w;
  leg.seenCentre = b.xyz;
  leg.boardTime = b.w;
  leg.toSeenX = texelFetch(legTexels, at + 2);
  leg.toSeenY = texelFetch(legTexels, at + 3);
  leg.toSeenZ = texelFetch(legTexels, at + 4);
  leg.toBoardTime = texelFetch(legTexels, at + 5);
  leg.newsInPrevious = texelFetch(legTexels, at + 6);
  leg.originInThis = texelFetch(legTexels, at + 7);
  leg.fromPrevious = mat4(texelFetch(legTexels, at + 8), texelFetch(legTexels, at + 9),
                          texelFetch(legTexels, at + 10), texelFetch(legTexels, at + 11));
  leg.glide = texelFetch(legTexels, at + 12);
  leg.glideTimes = texelFetch(legTexels, at + 13);
  return leg;
}
