// What the walls' panels and their mirror images share.
const vec3 kDado = vec3(0.13, 0.055, 0.03);  // linear, the share reflected
const float kDado_m = 1.1;                   // its height
