// Returns the legs of a body. A single leg comes from uniforms and is straight, and a spin on it even and
// solved in few steps; the leg of a body at rest on the board also has a known velocity. Two legs, where a
// shader is for just two, are straight and without spin. The compiler then leaves out what friction, spin,
// motion and further turns need.

#ifdef ONE_LEG
uniform vec4 onlyLeg[17];
#define LEG_TEXEL(i) onlyLeg[i]
#define LEG_COUNT 1
#else
uniform samplerBuffer legTexels;
#define LEG_TEXEL(i) texelFetch(legTexels, at + i)
#ifdef TWO_LEGS
#define LEG_COUNT 2
#else
#define LEG_COUNT legCount
#endif
#endif
#if defined(ONE_LEG) || defined(TWO_LEGS)
#define GLIDE vec4(0.0)
#else
#define GLIDE LEG_TEXEL(12)
#endif
#if defined(SPINS) && !defined(ONE_LEG)
#define SPIN_SLOWS LEG_TEXEL(16)
#else
#define SPIN_SLOWS vec4(0.0)
#endif
#ifndef SPINS
#define SPIN vec4(0.0)
#elif defined(ONE_LEG)
#define SPIN vec4(LEG_TEXEL(15).xyz, FEW_SPIN_STEPS)
#else
#define SPIN LEG_TEXEL(15)
#endif
#ifdef RESTS
#define BOARD_TIME_ROW vec4(1.0, 0.0, 0.0, 0.0)
#define MOMENT_ROW BOARD_TIME_ROW
#else
#define BOARD_TIME_ROW LEG_TEXEL(5)
#define MOMENT_ROW LEG_TEXEL(14)
#endif

LegView legAt(int first, int i) {
  int at = 17 * (first + i);
  vec4 a = LEG_TEXEL(0);
  vec4 b = LEG_TEXEL(1);
  LegView leg;
  leg.eye = a.xyz;
  leg.distance = a.w;
  leg.seenCentre = b.xyz;
  leg.boardTime = b.w;
  leg.toSeenX = LEG_TEXEL(2);
  leg.toSeenY = LEG_TEXEL(3);
  leg.toSeenZ = LEG_TEXEL(4);
  leg.toBoardTime = BOARD_TIME_ROW;
  leg.signalInPrevious = LEG_TEXEL(6);
  leg.originInThis = LEG_TEXEL(7);
  leg.fromPrevious = mat4(LEG_TEXEL(8), LEG_TEXEL(9), LEG_TEXEL(10), LEG_TEXEL(11));
  leg.glide = GLIDE;
  leg.glideTimes = LEG_TEXEL(13);
  leg.toMoment = MOMENT_ROW;
  leg.spin = SPIN;
  leg.spinSlows = SPIN_SLOWS;
  return leg;
}
