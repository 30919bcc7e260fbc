// Colours of shifted light, once: this text is compiled as GLSL in the vertex shader and as C++ (over GLM) in
// engine/colour/doppler_colour.h, where the equations stand. The including source provides the types real,
// vec2, vec3, vec4, mat3, KERNEL (the beginning of a function definition), the type COLOUR_TABLE by which the
// texels of a ColourTable are reached and, afterwards, the function colourTexel.

/// ν_B/ν_A of light that travels along the unit vector `ray` of frame A, where B moves with (γ, u): the
/// light's wave vector against B's four-velocity. Frame A is the board for all lamps, bodies and heads.
KERNEL real dopplerInto(real gamma, vec3 u, vec3 ray) { return gamma - dot(u, ray); }

/// The direction in B of the same light: a rotation-free boost of (1, ray).
KERNEL vec3 aberratedInto(real gamma, vec3 u, vec3 ray) {
  return (ray + u * (dot(u, ray) / (gamma + real(1)) - real(1))) / dopplerInto(gamma, u, ray);
}

/// Light in six narrow bands: radiance at 420, 465, 515, 570, 630 and 700 nm, as it arrives at the head, in
/// units of the reference light's there.
struct Bands {
  vec4 first;
  vec2 last;
};

/// One row of the table at a Doppler factor, interpolated in its logarithm.
vec4 colourTexel(COLOUR_TABLE table, int row, real bodyToHead);

/// hc/(λkT) of the bands at the reference temperature.
const vec4 kBandsFirst = vec4(5.2702, 4.7602, 4.2981, 3.8833);
const vec2 kBandsLast = vec2(3.5135, 3.1621);

/// A black body of `heat` times the reference temperature, B(λ, heat T)/B(λ, T) = (e^x − 1)/(e^(x/heat) − 1).
KERNEL Bands blackBody(real heat) {
  return Bands((exp(kBandsFirst) - real(1)) / (exp(min(kBandsFirst / heat, vec4(80.0))) - real(1)),
               (exp(kBandsLast) - real(1)) / (exp(min(kBandsLast / heat, vec2(80.0))) - real(1)));
}

KERNEL Bands added(Bands light, real share, Bands more) {
  return Bands(light.first + share * more.first, light.last + share * more.last);
}

/// What radiance is multiplied by, beside the shift of its spectrum: 1 if shift and searchlight go together.
KERNEL real radiancePower(real doppler, bool colour, bool searchlight) {
  real square = doppler * doppler;
  return (searchlight ? square * square : real(1)) / (colour ? square * square : real(1));
}

/// The same for the light of a lamp, small in the sky of the body that it lights, of whose solid angle there
/// aberration makes 1/D².
KERNEL real lampPower(real lampToBody, bool colour, bool searchlight) {
  real solidAngle = searchlight ? real(1) / (lampToBody * lampToBody) : real(1);
  return solidAngle * radiancePower(lampToBody, colour, searchlight);
}

/// Linear sRGB that white surfaces show, per unit of light in each band: whiteOfBands().
const vec4 kWhiteRedFirst = vec4(0.0560706, -0.0101282, -0.5170133, 0.6576113);
const vec2 kWhiteRedLast = vec2(0.8027064, 0.0108682);
const vec4 kWhiteGreenFirst = vec4(-0.0415966, -0.0526664, 0.6202049, 0.5237534);
const vec2 kWhiteGreenLast = vec2(-0.0499900, 0.0002643);
const vec4 kWhiteBlueFirst = vec4(0.3166909, 0.8234644, -0.0658254, -0.0622287);
const vec2 kWhiteBlueLast = vec2(-0.0117290, -0.0002006);

KERNEL vec3 seenWhite(Bands light) {
  return vec3(dot(light.first, kWhiteRedFirst) + dot(light.last, kWhiteRedLast),
              dot(light.first, kWhiteGreenFirst) + dot(light.last, kWhiteGreenLast),
              dot(light.first, kWhiteBlueFirst) + dot(light.last, kWhiteBlueLast));
}

/// Temperature of matter whose heat makes it 1 + `heat` times as heavy as it is cold, over the reference
/// temperature: T = 800 K + 2400 K (M/m − 1), at most 6500 K.
KERNEL real temperatureOf(real heat) { return min((real(800) + real(2400) * heat) / real(6500), real(1)); }

/// Luminance of the reference light itself, 683 lm/W ∫ ȳ B(λ, 6500 K) dλ, over that of white in the hall,
/// which is lit like a film set: 2000 cd/m².
const real kReferenceOverHall = real(1.5372e6);

/// Linear sRGB of the light that hot matter emits, a black body in its own frame: at the head one of D times
/// the temperature.
KERNEL vec3 seenGlow(real heat, real bodyToHead, bool colour, bool searchlight) {
  real temperature = temperatureOf(heat) * (colour ? bodyToHead : real(1));
  return kReferenceOverHall * radiancePower(bodyToHead, colour, searchlight) * seenWhite(blackBody(temperature));
}

/// Bright light as film takes it: its colour stays, and its luminance Y becomes Y/(1 + Y/2), as exposed by
/// `gain`, which never exceeds 2: the print on glowing matter can then be read.
KERNEL vec3 onFilm(vec3 light, real gain) {
  return light / (real(1) + real(0.5) * gain * max(dot(light, vec3(0.2126, 0.7152, 0.0722)), real(0)));
}

/// The matrix that takes a surface's colour, as it is at rest under the reference light, to the colour seen:
/// its columns are what red, green and blue surfaces show. Green is what white has more than those two.
KERNEL mat3 seenColour(COLOUR_TABLE table, Bands light, real bodyToHead) {
  vec4 a = colourTexel(table, 6, bodyToHead);
  vec4 b = colourTexel(table, 7, bodyToHead);
  vec4 c = colourTexel(table, 8, bodyToHead);
  vec3 red = vec3(dot(light.first, colourTexel(table, 0, bodyToHead)) + dot(light.last, vec2(a.x, a.y)),
                  dot(light.first, colourTexel(table, 1, bodyToHead)) + dot(light.last, vec2(a.z, a.w)),
                  dot(light.first, colourTexel(table, 2, bodyToHead)) + dot(light.last, vec2(b.x, b.y)));
  vec3 blue = vec3(dot(light.first, colourTexel(table, 3, bodyToHead)) + dot(light.last, vec2(b.z, b.w)),
                   dot(light.first, colourTexel(table, 4, bodyToHead)) + dot(light.last, vec2(c.x, c.y)),
                   dot(light.first, colourTexel(table, 5, bodyToHead)) + dot(light.last, vec2(c.z, c.w)));
  return mat3(red, seenWhite(light) - red - blue, blue);
}
