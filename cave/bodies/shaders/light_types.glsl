// The types in which light is interpolated from the vertices to the points of a surface. With shifted
// colours, the light that a surface returns is not the product of its colour and the light's colour; a matrix
// takes its place.
#ifdef COLOUR
#define LIGHT mat3
#define SHINE vec3
#define SHINE_COLOUR 1.0
#else
#define LIGHT vec3
#define SHINE float
#define SHINE_COLOUR kLampColour
#endif
const vec3 kLampColour = vec3(1.0, 0.90, 0.76);  // of the lamps' light on white surfaces at rest
