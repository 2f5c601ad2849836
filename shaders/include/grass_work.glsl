// What the culling passes hand on: blades of each tile, chunks of each work-group of tiles.
#define GRASS_WORK_LEVEL 28u

layout(std430, binding = RENDER_SSBO_TILE_WORK) buffer TileWork { uint tileWork[]; };    // blades | level << GRASS_WORK_LEVEL
layout(std430, binding = RENDER_SSBO_GROUP_WORK) buffer GroupWork { uvec4 groupWork[]; };  // chunks by level; after the scan: before it

uint bladesOfWork(uint work) { return work & ((1u << GRASS_WORK_LEVEL) - 1u); }
uint chunksOfWork(uint work) { return (bladesOfWork(work) + GRASS_CHUNK - 1u) / GRASS_CHUNK; }
