// Colours a point of a surface: paints it, lights it, and encodes the result for the screen.

in vec3 place;          // in the body's rest frame, from its centre (metres)
in vec3 surface;        // what the model says for painting
#ifndef GHOST
#ifdef LAMPS
in vec3 fromEyeOnBoard_m;        // the way back along which the light came
uniform vec3 lampsFromEye_m[3];
in LIGHT lampLight0, lampLight1, lampLight2;  // as `light`, of each lamp once its light has arrived
uniform vec3 lampsOn_m;          // c (t_on − t_o)
uniform vec3 lampLights[3];
#else
in LIGHT light;         // times the share reflected is what the eye receives (linear)
#endif
#ifdef GLOWS
in LIGHT glow;          // times light of its own is that
#endif
#ifdef HOT
in vec3 heatGlow;       // what matter that is not printed on sends by its heat
#endif
#ifdef EACH_SHINE
in SHINE lampShine0, lampShine1, lampShine2;  // by the varnish, of each lamp
#elif !defined(MATT)
in SHINE shine;         // mirrored by its varnish
#endif
in float tone;          // of its surface, as if it were painted evenly
#endif
in float boardTime_m;   // c (t − t_o) of the emission

flat in vec3 colour;    // linear, the share reflected
flat in vec3 exposure;  // gain, rise, fall: engine/colour/exposure.h

out vec4 pixel;

struct Painted {
  vec3 reflects;  // share of the light, linear
  vec3 shines;    // light of its own
  float cover;    // 1: opaque
};

/// The size of this pixel in x's unit: edges are drawn about that wide. Divisions by it, as all of them, cost
/// llvmpipe as much as eight multiplications: where there are several, it is divided by once.
float footprintOf(float x) { return max(fwidth(x), 1e-6); }
vec2 footprintOf(vec2 x) { return max(fwidth(x), 1e-6); }

/// 0 to the left of x = 0, 1 to the right, soft over a pixel; x in pixels.
float edge(float x_px) { return clamp(x_px + 0.5, 0.0, 1.0); }

/// How much of this pixel lies in lines of width `width` at whole numbers of x, and of y: the box-filtered
/// pulse train, from its integral. `perUnit_px`: 1/footprint.
vec2 lines(vec2 x, float width, vec2 footprint, vec2 perUnit_px) {
  vec2 a = x + (0.5 * width - 0.5 * footprint);
  vec2 b = a + footprint;
  vec2 wholeA = floor(a), wholeB = floor(b);
  vec2 covered = (wholeB - wholeA) * width + (min(b - wholeB, width) - min(a - wholeA, width));
  return clamp(covered * perUnit_px, 0.0, 1.0);
}
float lines(float x, float width) {
  vec2 footprint = vec2(footprintOf(x));
  return lines(vec2(x), width, footprint, 1.0 / footprint).x;
}

/// From 0 to 1 without a bend at the ends: smoothstep.
float soft(float share) { return share * share * (3.0 - 2.0 * share); }

/// Linear light to sRGB: the curve of IEC 61966-2-1 to within 1.5 steps of 255, at the price of one root.
vec3 toScreen(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  return 1.2345 * sqrt(x) - 0.2172 * x - 0.0231;
}

/// Linear light as the picture is exposed, for the screen.
vec3 shown(vec3 linear) {
  if (!COLOURED && !SEARCHLIGHT) {
    // The exposure is then always the same, and both curves together are within 1.5 steps of 255 a cubic of
    // the root.
    vec3 root = sqrt(clamp(linear, 0.0, 1.57));
    return ((0.05259 * root - 0.44084) * root + 1.28424) * root - 0.02573;
  }
  vec3 x = max(exposure.x * linear, 0.0);
  return toScreen(x * (1.0 + exposure.y * x) / (1.0 + exposure.z * x));
}

#if defined(LAMPS) && !defined(GHOST)
/// Which lamps' light had arrived here when this place sent the light that the eye receives. That event lies
/// on the eye's past cone, so c (t − t_o) = −|r − r_o|, exact in every pixel; the phase of lamp i is
///   c (t − t_o) − |r − r_i| − c (t_on,i − t_o)
/// and its edge is as wide as a pixel.
vec3 arrivedLamps() {
  float sent_m = RETARDED ? -length(fromEyeOnBoard_m) : 0.0;
  vec3 way_m = vec3(length(fromEyeOnBoard_m - lampsFromEye_m[0]), length(fromEyeOnBoard_m - lampsFromEye_m[1]),
                    length(fromEyeOnBoard_m - lampsFromEye_m[2]));
  vec3 phase_m = sent_m - way_m - lampsOn_m;
  return clamp(phase_m / max(fwidth(phase_m), 1e-6) + 0.5, 0.0, 1.0);
}

#ifdef BULB
/// The light of the bulb that is here, if it is on: other lamps of the hall stay dark.
vec3 ofBulbs(vec3 arrived) {
  const float kBulb_m = 0.3;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    if (length(fromEyeOnBoard_m - lampsFromEye_m[i]) > kBulb_m) continue;
    sum = max(sum, arrived[i] * lampLights[i] / max(max(lampLights[i].r, lampLights[i].g), max(lampLights[i].b, 1e-3)));
  }
  return sum;
}
#endif
#endif

#ifdef HOT
/// How bright the print on a hot body leaves it: dark ink glows as little as it reflects, so that lines and
/// letters stay visible.
float throughPrint(vec3 reflects) {
  const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);
  return min(dot(reflects, kLuminance) / max(dot(colour, kLuminance), 1e-3), 1.0);
}
#endif

//CAROM::Paint

void main() {
  Painted painted = paint();
#ifdef MIRRORS
  vec3 normal = mirrorNormal;
  vec3 toEye = normalize(eyeHere_m - place);
#ifndef LAMPS
  painted.reflects = withMirroredHall(painted.reflects, normal, toEye);
#endif
#endif
#ifdef GHOST
  pixel = vec4(toScreen(painted.shines), painted.cover);
#else
#ifdef LAMPS
  vec3 arrived = arrivedLamps();
  vec3 seen = arrived[0] * (lampLight0 * painted.reflects) + arrived[1] * (lampLight1 * painted.reflects) +
              arrived[2] * (lampLight2 * painted.reflects);
#else
  vec3 arrived = vec3(1.0);
  vec3 seen = light * painted.reflects;
#endif
#ifdef MIRRORS
  arrived *= mirroredLamps(normal, toEye);
#endif
#ifdef EACH_SHINE
  seen += SHINE_COLOUR * (arrived[0] * lampShine0 + arrived[1] * lampShine1 + arrived[2] * lampShine2);
#elif !defined(MATT)
  seen += SHINE_COLOUR * shine;
#endif
#ifdef BULB
  painted.shines *= ofBulbs(arrived);
#endif
#ifdef GLOWS
  seen += glow * painted.shines;
#endif
#ifdef HOT
  seen += heatGlow * throughPrint(painted.reflects);
#endif
#ifdef SHADOW
  float alpha = painted.cover;
#else
  float alpha = tone;  // between which cave/render/edge_pixels.h finds edges
#endif
  pixel = vec4(shown(seen), alpha);
#endif
}
