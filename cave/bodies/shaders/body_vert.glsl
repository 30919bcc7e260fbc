// Transforms a vertex of a body from its place in the body's rest frame to the place where the eye sees it,
// and computes the light that falls on it there.
//
// The program is compiled with these macros. True or false are the switches RETARDED, CONTRACTED, ABERRATED,
// COLOURED and SEARCHLIGHT, and BOARD_NOW, which is true for bodies at the observation's board time. Defined
// or not are: EUCLID, all switches are off; COLOUR, colours are shifted; CLOCK, the part is a clock; MATT, it
// has no varnish; EACH_SHINE, the light of each lamp on the varnish is handed on by itself; MIRRORS, a pixel
// mirrors it (mirror.glsl), not a vertex; SHADOW, it is the shadow of a puck on the cloth; GLOWS, it emits
// light of its own; HOT, its matter glows by its heat; GHOST, the body is shown at one moment and is not lit;
// LAMPS, the only light is that of lamps that go on, as it arrives; FOLLOWED, its points move by themselves
// and have been solved for.
// Theory: app/doc/physics.md, Colour.

in vec4 vertexMC;   // from the body's centre, in its rest frame (metres)
in vec3 normalMC;
in vec3 surfaceMC;  // for painting
in vec4 litMC;      // share of each lamp's light and of the hall's that reaches it past what rests

#ifdef FOLLOWED
in vec4 sightMC;    // where it is drawn, from the eye; c (t − t_o) of the emission
in vec4 motionMC;   // γβ then, in the board's frame; what its colour may tell
uniform vec4 middleMotion;     // γ, γβ of its middle
#endif

uniform int firstLeg;          // of this body, in legTexels
uniform int legCount;          // reached as LEG_COUNT: 1 for what rests
uniform mat4 drawnFromBody;    // EUCLID: the body's place, without a solve
uniform float appears_m;       // c (t − t_o) before which the body did not exist
// The frame in which walls draw: the head's, or as the switches say; from the eye.
uniform mat4 clipFromDrawn;
uniform mat4 drawnFromSeen;    // displacements (c t, x, y, z), here and in the next line
uniform mat4 boardFromDrawn;
uniform vec4 headOnBoard;      // γ, γβ
uniform vec3 eyeOnBoard_m;     // where the eye receives the light
uniform vec3 lamps_m[3];       // at rest on the board
#ifdef MIRRORS
uniform vec4 hall_m;           // from its middle to the walls towards x and y; heights of floor and ceiling
uniform float roughness;       // of its varnish
#endif
uniform vec3 partColour;       // linear, the share reflected
uniform float seenShare;       // of its light, which the picture shows
uniform float tint;            // 0, 1 or 2, of this part
uniform vec3 eyeExposure;      // engine/colour/exposure.h
uniform float nearer;          // share by which decals are drawn nearer than they are

out vec3 place;       // vertexMC, for painting
out vec3 surface;
#ifdef GHOST
out vec3 fromEye_m;   // where it is drawn
#else
#ifdef MIRRORS
out vec3 mirrorNormal;
flat out vec3 eyeHere_m, lampHere0_m, lampHere1_m, lampHere2_m;  // on the board
flat out vec4 hallHere_m;
flat out float polish;
#endif
#ifdef LAMPS
out vec3 fromEyeOnBoard_m;  // the way back along which the light came
uniform vec3 lampsFromEye_m[3];
uniform vec3 lampsOn_m;     // c (t_on − t_o)
uniform vec3 lampLights[3]; // linear
out LIGHT lampLight0, lampLight1, lampLight2;  // as `light`, of each lamp once its light has arrived
#else
out LIGHT light;      // received by the surface: times its colour is what the eye receives (linear)
#endif
#ifdef GLOWS
out LIGHT glow;       // the same for light of its own
#endif
#ifdef HOT
out vec3 heatGlow;    // what its heat sends to the eye (linear)
#endif
#ifdef EACH_SHINE
out SHINE lampShine0, lampShine1, lampShine2;  // as `shine`, by each lamp; with MIRRORS not yet mirrored
#elif !defined(MATT)
out SHINE shine;      // mirrored to the eye by its varnish
#endif
// 0 to 1: how bright it is as if it were painted evenly, and set off from parts of another tint.
out float tone;
#endif
#ifdef FOLLOWED
out float told;       // motionMC.w
#endif
out float boardTime_m;  // c (t − t_o) of the emission
// Uniforms, handed on: llvmpipe reads those of pixels one by one, with a check for each.
flat out vec3 colour;
flat out vec3 exposure;

#if defined(LAMPS) && !defined(GHOST)
/// Whether the light of a lamp had arrived at a place, given from the eye, when that sent the light that the
/// eye receives: c (t − t_o) ≥ c (t_on − t_o) + |r − r_lamp|.
bool isLitBy(int i, vec3 way_m) {
  float sent_m = RETARDED ? -length(way_m) : 0.0;
  return sent_m >= lampsOn_m[i] + length(way_m - lampsFromEye_m[i]);
}

LIGHT tinted(LIGHT received, vec3 lamp) {
#ifdef COLOUR
  return mat3(lamp * received[0], lamp * received[1], lamp * received[2]);
#else
  return lamp * received;
#endif
}
#endif

const float kLampStrength_m2 = 1.1;  // light on a surface at 1 m that faces the lamp

/// A lamp's light at the end of this way, where it falls straight.
float lampStrength(vec3 ray) { return kLampStrength_m2 / (dot(ray, ray) + 0.3); }

/// The hall's own light, white: soft, from above more than from below.
float hallLight(vec3 normal) { return mix(0.32, 0.66, 0.5 + 0.5 * normal.z); }

#ifdef COLOUR
// Of two sorts of light, both a black body's; the lamp's is 0.848 times as hot as the reference.
Bands hallSpectrum(float doppler) { return blackBody(doppler); }
Bands lampSpectrum(float doppler) { return blackBody(0.848 * doppler); }
const float kLampPower = 1.88;  // in units of its own white at rest: then kLampColour below is what it shows
#endif

vec3 normalInLeg;  // normalMC as the body has turned it by the emission

/// Where the vertex is drawn, from the eye, and how fast its leg and, in the rest frame of that, it itself
/// was: γ, γβ.
struct Sight {
  vec3 drawn;
  float gamma;
  vec3 u;
  vec4 turning;
};

const vec4 kRests = vec4(1.0, 0.0, 0.0, 0.0);

#ifdef FOLLOWED
Sight sightOf(vec3 d) {
  boardTime_m = sightMC.w;
  normalInLeg = normalMC;
#ifdef EUCLID
  return Sight(sightMC.xyz, 1.0, vec3(0.0), kRests);
#else
  return Sight(sightMC.xyz, sqrt(1.0 + dot(motionMC.xyz, motionMC.xyz)), motionMC.xyz, kRests);
#endif
}
#elif defined(EUCLID)
Sight sightOf(vec3 d) {
  boardTime_m = 0.0;
  LegView leg = legAt(firstLeg, 0);
  normalInLeg = carriedAlong(leg, vec4(0.0), normalMC);
  return Sight((drawnFromBody * vec4(carriedAlong(leg, vec4(0.0), d), 1.0)).xyz, 1.0, vec3(0.0), kRests);
}
#else
/// γ, γβ of the point at x of a spinning body at this own time of the leg, in the leg's frame.
vec4 turningOf(LegView leg, vec3 x, float own) {
  if (leg.spin.w == 0.0) return kRests;
  vec3 w = spinVelocity(leg, x, own);
  return vec4(1.0, w) * inversesqrt(max(1.0 - dot(w, w), 1e-6));
}

/// Where the vertex is drawn. Sets boardTime_m and normalInLeg.
Sight sightOf(vec3 d) {
  VertexEmission emission = solveEmission(firstLeg, LEG_COUNT, d, RETARDED, CONTRACTED);
  LegView leg = legAt(firstLeg, emission.leg);
  vec3 drawn = seenFromEye(leg, emission.event);
  if (ABERRATED && BOARD_NOW) drawn = rayThrough(drawnFromSeen, drawn);
  boardTime_m = BOARD_NOW ? 0.0 : boardTimeOf(leg, emission.event);
  normalInLeg = carriedAlong(leg, emission.event, normalMC);
  // A vertex that is catching up is lit as on its incoming leg: its colour must not flash.
  float own = emission.event.x;
  vec3 x = emission.event.yzw;
  if (emission.catchingUp) {
    LegView incoming = legAt(firstLeg, emission.leg - 1);
    if (incoming.spin.w > 0.0) {
      own = (inverse(leg.fromPrevious) * (emission.event - leg.originInThis)).x;
      x = spinPlace(incoming, d, own);
    }
    leg = incoming;
  }
  // The first row of toBoardTime takes (c t, x) to γ (c t + β·x).
  return Sight(drawn, leg.toBoardTime.x, leg.toBoardTime.yzw, turningOf(leg, x, own));
}
#endif

/// The direction, in the body's rest frame, of light that travels along `ray` on the board.
vec3 inBodyFrame(Sight sight, vec3 ray) {
  return ABERRATED ? aberratedInto(sight.gamma, sight.u, ray) : ray;
}

/// The same in the rest frame of the vertex, which turns with its body.
vec3 inVertexFrame(Sight sight, vec3 ray) {
  vec3 inBody = inBodyFrame(sight, ray);
  return sight.turning.x > 1.0 && ABERRATED ? aberratedInto(sight.turning.x, sight.turning.yzw, inBody) : inBody;
}

/// Its frequency there over that on the board.
float dopplerIntoVertex(Sight sight, vec3 ray) {
  float doppler = dopplerInto(sight.gamma, sight.u, ray);
  if (sight.turning.x <= 1.0) return doppler;
  return doppler * dopplerInto(sight.turning.x, sight.turning.yzw, aberratedInto(sight.gamma, sight.u, ray));
}

/// The normal of the surface in the rest frame of the vertex: steeper along the motion, which is
/// longer in that frame.
vec3 normalInVertexFrame(Sight sight) {
  vec3 normal = normalInLeg;
  if (sight.turning.x > 1.0)
    normal += sight.turning.yzw * (dot(sight.turning.yzw, normal) / (sight.turning.x + 1.0));
  // A spike of a mesh may have none.
  return normal * inversesqrt(max(dot(normal, normal), 1e-12));
}

#ifndef GHOST
/// The way on the board along which the light came; what rests is where its mesh has it.
vec3 onBoardFromEye(Sight sight) {
#ifdef RESTS
  return vertexMC.xyz - eyeOnBoard_m;
#else
  return ABERRATED ? rayThrough(boardFromDrawn, sight.drawn) : (boardFromDrawn * vec4(0.0, sight.drawn)).yzw;
#endif
}

#ifdef HOT
#ifndef FOLLOWED
// The collisions that heated the body (cave/bodies/hot_bodies.h): c (t − t_o) and the place from the eye, on
// the board; the heat that each brought, over m c²; c times the own time in which 1/e of it is left.
uniform vec4 blows[4];
uniform vec4 blowHeats;
uniform float cooling_m;
#endif

/// The heat of the matter that is seen here, over m c².
float heatAt(vec3 fromEye_m) {
#ifdef FOLLOWED
  return motionMC.w;
#else
  float heat = 0.0;
  for (int i = 0; i < 4; ++i) {
    float since_m = boardTime_m - blows[i].x;
    vec3 way_m = fromEye_m - blows[i].yzw;
    float square = since_m * since_m - dot(way_m, way_m);
    if (since_m > 0.0 && square > 0.0) heat += blowHeats[i] * exp(-sqrt(square) / cooling_m);
  }
  return heat;
#endif
}
#endif

/// Follows the light from hall and lamps to the eye.
void lightUp(Sight sight) {
  vec3 fromEye_m = onBoardFromEye(sight);
  vec3 onBoard_m = eyeOnBoard_m + fromEye_m;
  vec3 towardsEye = normalize(-fromEye_m);
  float toHead = dopplerInto(headOnBoard.x, headOnBoard.yzw, towardsEye) /
                 dopplerIntoVertex(sight, towardsEye);
  float headPower = seenShare * radiancePower(toHead, COLOURED, SEARCHLIGHT);
  vec3 toEye = inVertexFrame(sight, towardsEye);
  vec3 normal = normalInVertexFrame(sight);

  // The hall's light as if all of it came from where light on a matt surface does on average, 2/3 being the
  // mean cosine: from direction n of the body's sky D = 1/(γ − u·n).
  float hallToBody = 1.0 / (dopplerInto(sight.gamma, sight.u, normal * (2.0 / 3.0)) *
                            dopplerInto(sight.turning.x, sight.turning.yzw, normal * (2.0 / 3.0)));
#ifdef MIRRORS
  mirrorNormal = normal;
  eyeHere_m = eyeOnBoard_m;
  lampHere0_m = lamps_m[0], lampHere1_m = lamps_m[1], lampHere2_m = lamps_m[2];
  hallHere_m = hall_m;
  polish = roughness;
#endif
#ifdef LAMPS
  fromEyeOnBoard_m = fromEye_m;
  LIGHT lampLight[3];
#endif
#ifdef EACH_SHINE
  SHINE lampShine[3];
#endif
  float hall = litMC.w * hallLight(normal) * headPower * radiancePower(hallToBody, COLOURED, SEARCHLIGHT);
#ifdef COLOUR
  Bands received = added(Bands(vec4(0.0), vec2(0.0)), hall, hallSpectrum(hallToBody * toHead));
#elif !defined(LAMPS)
  light = vec3(hall);
#endif
#if !defined(MATT) && !defined(EACH_SHINE)
  shine = SHINE(0.0);
#endif
  for (int i = 0; i < 3; ++i) {
    vec3 ray = onBoard_m - lamps_m[i];
    vec3 lampRay = normalize(ray);
    vec3 toLamp = -inVertexFrame(sight, lampRay);
    float lampToBody = dopplerIntoVertex(sight, lampRay);
    float strength = litMC[i] * lampStrength(ray) * headPower * lampPower(lampToBody, COLOURED, SEARCHLIGHT);
    float facing = max(dot(normal, toLamp), 0.0);
#ifdef MIRRORS
    float varnish = strength;  // mirrored pixel by pixel
#elif !defined(MATT)
    float varnish = facing > 0.0 ? strength * highlight(normal, toLamp, toEye) : 0.0;
#endif
#ifdef LAMPS
#ifdef COLOUR
    Bands lamp = lampSpectrum(lampToBody * toHead);
    Bands ofLamp = added(Bands(vec4(0.0), vec2(0.0)), kLampPower * strength * facing, lamp);
    lampLight[i] = tinted(seenColour(0, ofLamp, toHead), lampLights[i]);
#ifndef MATT
    lampShine[i] = kLampPower * varnish * seenWhite(lamp) * lampLights[i];
#endif
#else
    lampLight[i] = kLampColour * lampLights[i] * (strength * facing);
#ifndef MATT
    lampShine[i] = varnish * dot(lampLights[i], vec3(1.0 / 3.0));
#endif
#endif
#elif defined(COLOUR)
    Bands lamp = lampSpectrum(lampToBody * toHead);
    received = added(received, kLampPower * strength * facing, lamp);
#ifdef EACH_SHINE
    lampShine[i] = kLampPower * varnish * seenWhite(lamp);
#elif !defined(MATT)
    shine += kLampPower * varnish * seenWhite(lamp);
#endif
#else
    light += kLampColour * (strength * facing);
#ifdef EACH_SHINE
    lampShine[i] = varnish;
#elif !defined(MATT)
    shine += varnish;
#endif
#endif
  }
#ifdef EACH_SHINE
  lampShine0 = lampShine[0], lampShine1 = lampShine[1], lampShine2 = lampShine[2];
#endif
#ifdef LAMPS
  lampLight0 = lampLight[0], lampLight1 = lampLight[1], lampLight2 = lampLight[2];
#elif defined(COLOUR)
  light = seenColour(0, received, toHead);
#endif
#ifdef HOT
  heatGlow = seenShare * onFilm(seenGlow(heatAt(fromEye_m), toHead, COLOURED, SEARCHLIGHT), eyeExposure.x);
#endif
#ifdef GLOWS
#ifdef COLOUR
  glow = headPower * seenColour(0, hallSpectrum(toHead), toHead);
#else
  glow = vec3(headPower);
#endif
#endif
}
#endif

#if defined(SHADOW) && defined(SPINS)
/// The share of the way from the axis at which a place of the shadow lies in its body. Places farther out, by
/// the reach of its light's shadow (cave/scene/shadow_model.cpp), are not of the body: if it turned with it,
/// it could outrun light, or come late after a bounce.
float shareInBody(vec3 d) {
  float radius = max(length(d.xy), 1e-6);
  float beside = surfaceMC.x * surfaceMC.z * (surfaceMC.y > 2.5 ? 0.9 : 0.3);
  return max(1.0 - beside / radius, 0.25);
}
#endif

#ifdef SHADOW
/// The shadow of one light (surfaceMC.y: a lamp, or 3, the hall, whose light comes from above on average) is
/// what the puck hides from its lower rim to its upper, surfaceMC.z higher: the shape under it, the same
/// shape where the upper rim's shadow lies, and all between. So those vertices are moved whose normal, out of
/// the puck, points away from the light. Light that passed the upper rim goes on for l to the cloth, while
/// the rim goes on, too: at one board time the shadow is from its rim
///   Δ = l (n − β)   (n: the ray's direction)
/// and goes with it, as the puck's centre goes: while the signal of a blow runs through the puck its rim
/// moves in many ways, and the shadow is to stay one. The eye sees it at s = c (t − t_rim) with T − s = |D −
/// β s|, D from there to the eye, T from the rim.
Sight shadowed(Sight sight, Sight centre, out float share) {
  vec3 fromEye_m = onBoardFromEye(sight);
  vec3 at = eyeOnBoard_m + fromEye_m;
  int sort = int(surfaceMC.y + 0.5);
  vec3 n = vec3(0.0, 0.0, -1.0);
#ifdef LAMPS
  float all = 1e-6;
  share = 0.0;
#else
  float all = hallLight(-n);
  share = all;
#endif
  for (int i = 0; i < 3; ++i) {
    vec3 way = at - lamps_m[i];
    vec3 ray = normalize(way);
    float strength = lampStrength(way) * max(-ray.z, 0.0);
#ifdef LAMPS
    strength *= isLitBy(i, fromEye_m) ? dot(lampLights[i], vec3(1.0 / 3.0)) : 0.0;
#endif
    all += strength;
    if (i != sort) continue;
    n = ray;
    share = strength;
  }
  share /= all;
  // Of the hall's light, from everywhere, half of the puck's height stands for all of it.
  float height_m = sort == 3 ? 0.5 * surfaceMC.z : surfaceMC.z;
  vec3 inBody = inBodyFrame(centre, n);
  if (dot(normalInLeg.xy, inBody.xy) <= 0.0) return sight;
  vec3 beta = centre.u / centre.gamma;
  // The ray by the upper rim, where that was.
  if (sort < 3) n = normalize(at + vec3(0.0, 0.0, height_m) + beta * (height_m / n.z) - lamps_m[sort]);
  vec3 delta = height_m / max(-n.z, 0.05) * vec3(n.xy - beta.xy, 0.0);
  float s = 0.0;
  if (RETARDED) {
    vec3 D = -fromEye_m - delta;
    float b = length(fromEye_m) - dot(beta, D);
    float product = dot(D - fromEye_m, delta);  // T² − D²
    s = product / (b + sqrt(max(b * b - (1.0 - dot(beta, beta)) * product, 0.0)));
  }
  vec3 shadow = fromEye_m + delta + beta * s;
  mat4 drawnFromBoard = inverse(boardFromDrawn);
  sight.drawn = ABERRATED ? rayThrough(drawnFromBoard, shadow) : (drawnFromBoard * vec4(0.0, shadow)).yzw;
  return sight;
}
#endif

void main() {
  vec3 d = vertexMC.xyz;
#if defined(SHADOW) && defined(FOLLOWED)
  Sight centre = Sight(vec3(0.0), middleMotion.x, middleMotion.yzw, kRests);
#elif defined(SHADOW)
  Sight centre = sightOf(vec3(0.0));
#endif
#if defined(SHADOW) && defined(SPINS)
  float inBody = shareInBody(d);
  vec3 axis = sightOf(vec3(0.0, 0.0, d.z)).drawn;
  Sight sight = sightOf(vec3(inBody * d.xy, d.z));
  sight.drawn = axis + (sight.drawn - axis) / inBody;
#else
  Sight sight = sightOf(d);
#endif
#ifdef SHADOW
  float share;
  sight = shadowed(sight, centre, share);
#endif
#ifdef CLOCK
  if (RETARDED) {
    // A clock shows one time: when light left the middle of its face, a rectangle of width surfaceMC.z.
    vec2 fromMiddle = (surfaceMC.xy / vec2(4.0, 1.0) - 0.5) * surfaceMC.z * vec2(1.0, 0.4);
    vec3 right = cross(vec3(0.0, 0.0, 1.0), normalMC);
    sightOf(d - right * fromMiddle.x - vec3(0.0, 0.0, fromMiddle.y));
  }
#endif

  colour = partColour;
  exposure = eyeExposure;
  gl_Position = clipFromDrawn * vec4(sight.drawn * (1.0 - nearer), 1.0);
  gl_ClipDistance[0] = boardTime_m - appears_m;
  place = d;
  surface = surfaceMC;
#ifdef FOLLOWED
  told = motionMC.w;
#endif
#ifdef SHADOW
  surface.y = share;
#endif
#ifdef GHOST
  fromEye_m = sight.drawn;
#else
  lightUp(sight);
#ifdef LAMPS
  tone = tint / 2.6;
#else
  float bright = eyeExposure.x * max(dot(light * partColour, vec3(0.2126, 0.7152, 0.0722)), 0.0);
#ifdef GLOWS
  bright += eyeExposure.x * dot(glow * partColour, vec3(0.2126, 0.7152, 0.0722));
#endif
#ifdef HOT
  bright += eyeExposure.x * max(dot(heatGlow, vec3(0.2126, 0.7152, 0.0722)), 0.0);
#endif
  tone = (tint + 0.6 * bright / (bright + 0.2)) / 2.6;  // those of different tints never agree
#endif
#endif
}
