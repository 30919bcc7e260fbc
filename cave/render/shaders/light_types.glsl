// How light is handed from a vertex to the points of its surface. With colour, what comes back from a surface is no
// product of its colour and the light's: a matrix takes its place.
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
