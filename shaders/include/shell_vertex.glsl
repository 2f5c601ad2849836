// What the corners of a shell tell what is seen between them: members of ShellVertex.
// place       m in the world
// own         root where the texture lies: the world, or the surface's own axes, m
// root        m in the world
// up          along the grass
// normal      of what it grows on
// below       from the shell below to this one, m
// above       from this one to the shell above
// bend        direction times intensity
// push        part of it that colliders give
// size        x tallest blade m; y height of this shell over its root m; z height of the canopy over that of the open meadow
// light       x part of the blades that grow; y dryness; z brightness with the slope's light and colliders'; w |F| of eq. 14
// shade       x m over the root that solids and hills hide from the sun; y to the nearest solid, m; zw wind, m/s
// footLight   light over the albedo at the foot of blades
// topLight    and at their top
// afarLight   light of the canopy where blades can't be told apart
// haze        colour and part of the air before it
#define SHELL_VERTEX_MEMBERS vec3 place; vec3 own; vec3 root; vec3 up; vec3 normal; vec3 below; vec3 above; vec3 bend; vec3 push; vec3 size; vec4 light; vec4 shade; vec3 footLight; vec3 topLight; vec3 afarLight; vec4 haze;
