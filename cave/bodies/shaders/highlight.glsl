// Lamps that rough varnish mirrors. `roughness`: Trowbridge and Reitz's α; 0: there is no varnish.
// Theory: app/doc/physics.md, Colour.
uniform float roughness;

/// The share of a lamp's light that varnish mirrors to the eye, over that which a white matt surface facing
/// the lamp reflects there: π D F G/(4 (n·e)), with unit vectors n, the normal, l to the lamp, e to the eye,
/// h = (l + e)/|l + e|, all in the rest frame of the surface, and
///   D = α²/(π ((n·h)² (α² − 1) + 1)²)       facets (Trowbridge and Reitz, JOSA 65, 531 (1975)),
///   G = G₁(n·l) G₁(n·e),  G₁(x) = 2x/(x + sqrt(α² + (1 − α²) x²))      lamp and eye see this share
///                                            (Walter and others, EGSR 2007),
///   F = F₀ + (1 − F₀) (1 − e·h)⁵,  F₀ = 0.04      each mirrors this much (Schlick 1994), as lacquer does.
float highlight(vec3 normal, vec3 toLamp, vec3 toEye) {
  if (roughness <= 0.0) return 0.0;
  vec3 middle = normalize(toLamp + toEye);
  float nl = dot(normal, toLamp), ne = dot(normal, toEye), nh = dot(normal, middle);
  if (nl <= 0.0 || ne <= 0.0) return 0.0;
  float square = roughness * roughness;
  float facets = nh * nh * (square - 1.0) + 1.0;
  float grazing = 1.0 - dot(toEye, middle), grazing2 = grazing * grazing;
  float mirrored = 0.04 + 0.96 * grazing2 * grazing2 * grazing;
  float inSight = (nl + sqrt(square + (1.0 - square) * nl * nl)) * (ne + sqrt(square + (1.0 - square) * ne * ne));
  return mirrored * square / (facets * facets) * nl / inSight;
}
