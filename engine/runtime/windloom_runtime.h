#ifndef WINDLOOM_RUNTIME_H
#define WINDLOOM_RUNTIME_H
/* Wind baked by Windloom, for games: loads a .windpack and tells the wind at a place and time. Plain C11,
 * needs the C standard library and nothing else; windloom_runtime_zstd, the same library with zstd, reads compressed
 * packs too. The file format is described in docs/windpack.md.
 *
 * Frame: right-handed, +Y up, metres, m/s; the wind lies in the XZ plane. Between cell centres and between
 * frames the wind is interpolated linearly. A loaded pack is never changed by sampling, so any number of
 * threads may sample one pack at the same time. */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct windloom_pack windloom_pack;

typedef enum windloom_status {
  WINDLOOM_OK = 0,
  WINDLOOM_CANNOT_READ,   /* the file is missing or can't be read */
  WINDLOOM_NOT_A_PACK,    /* it doesn't start as a .windpack does */
  WINDLOOM_NEWER_VERSION, /* written in a version of the format that this library doesn't know */
  WINDLOOM_TOO_LARGE,     /* it claims a size over the limits of the format; nothing was allocated */
  WINDLOOM_CUT_SHORT,     /* shorter or longer than its header says */
  WINDLOOM_DAMAGED,       /* the checksum is wrong, or a value makes no sense */
  WINDLOOM_OUT_OF_MEMORY,
  WINDLOOM_NEEDS_ZSTD,    /* compressed, and this library was built without zstd */
  WINDLOOM_NO_LIVE_FIELD, /* no editor shares a live field of that name */
  WINDLOOM_NOT_HERE       /* this system can't follow files, or has no shared memory that can be read as a file */
} windloom_status;

/* What happens to positions outside the field. */
typedef enum windloom_edge {
  WINDLOOM_CLAMP, /* the wind of the nearest border */
  WINDLOOM_WRAP   /* the field repeats; seamless where it was simulated periodic */
} windloom_edge;

typedef struct windloom_info {
  int width, height;  /* cells along x and z */
  int frames;         /* >= 1 */
  float min_x, min_z; /* m, low corner of the field */
  float max_x, max_z; /* m, high corner */
  float fps;          /* frames a second, > 0 */
  float max_speed;    /* m/s (rad for a response), no sample is faster */
  double start;       /* s: time of frame 0 in the project it was baked from */
  int loop;           /* 1: the last frame is followed by the first */
  windloom_edge edge_x, edge_z;
  int quantity;           /* 0: wind, m/s; 1: how plants lean, rad (a baked response) */
  float reference_height; /* m: height over the ground at which the wind is as stored, > 0 */
  float roughness;        /* m: roughness length of the ground, > 0; 0: the wind is the same at all heights */
} windloom_info;

/* A pack, or NULL with the reason in *status (which may be NULL). Everything is checked before it is
 * used. The memory given to windloom_load_memory is copied. windloom_free(NULL) does nothing. */
windloom_pack* windloom_load_file(const char* path, windloom_status* status);
windloom_pack* windloom_load_memory(const void* bytes, size_t size, windloom_status* status);
void windloom_free(windloom_pack* pack);

/* One English sentence, never NULL. */
const char* windloom_status_text(windloom_status status);

windloom_info windloom_get_info(const windloom_pack* pack);

/* Other edges than the file's. Not while another thread samples. */
void windloom_set_edges(windloom_pack* pack, windloom_edge x, windloom_edge z);

/* The wind in m/s at (x, z) in m, `time` seconds after the first frame. A looping pack repeats every
 * frames / fps seconds; another one stays at its first frame before and at its last frame after.
 * Numbers that are not finite are treated as 0. */
void windloom_sample(const windloom_pack* pack, float x, float z, double time, float velocity[2]);

/* The same for `count` places at one time: positions x0 z0 x1 z1 ... to velocities vx0 vz0 vx1 vz1 ...,
 * which may be the same array. */
void windloom_sample_many(const windloom_pack* pack, const float* positions, size_t count, double time,
                          float* velocities);

/* Part of the stored wind that blows `height` m over the ground: the logarithmic law
 * ln(1 + height / roughness) / ln(1 + reference_height / roughness); 0 at and below the ground, 1 everywhere where
 * the pack has no roughness. Multiply a sample with it. */
float windloom_height_factor(const windloom_pack* pack, float height);

/* Following a file: loads a pack and loads it again whenever the file was replaced, as an export does. */
typedef struct windloom_follow windloom_follow;

/* Never NULL but where memory is out; the file may come into being later. `path` is copied. */
windloom_follow* windloom_follow_open(const char* path);
/* Looks at the file (a few microseconds) and loads it where it is another one than last time. 1: there is a new pack,
 * 0: nothing changed, -1: the new file can't be loaded (see windloom_follow_status) and the last pack stays. A pack
 * that was replaced is freed at the next change, so threads that sample it have until then. One thread polls; any
 * thread may ask for the pack meanwhile. */
int windloom_follow_poll(windloom_follow* follow);
/* The pack that was loaded last, or NULL. */
const windloom_pack* windloom_follow_pack(const windloom_follow* follow);
windloom_status windloom_follow_status(const windloom_follow* follow);
void windloom_follow_close(windloom_follow* follow);

/* The live link: the wind of a running editor, through shared memory. */
typedef struct windloom_live windloom_live;

/* The field that an editor shares under `name` (NULL: "windloom"), or NULL with the reason. Takes all memory it will
 * ever need. A field has at most 512 cells a side. Where it was ended or left behind there is none: ask again later. */
windloom_live* windloom_live_open(const char* name, windloom_status* status);
/* Takes over the newest complete field. 1: newer than the last one, 0: nothing new, -1: the editor has ended the link
 * or is gone (the last field stays; open again to find the next editor). Never waits for the editor. Not while another
 * thread samples. */
int windloom_live_update(windloom_live* live);
/* Of the field taken over last: frames is 1, fps 0, start the time in the project; width is 0 before the first. */
windloom_info windloom_live_info(const windloom_live* live);
/* As windloom_sample, of that field; calm before the first one. */
void windloom_live_sample(const windloom_live* live, float x, float z, float velocity[2]);
/* As windloom_sample_many. */
void windloom_live_sample_many(const windloom_live* live, const float* positions, size_t count, float* velocities);
void windloom_live_close(windloom_live* live);

#ifdef __cplusplus
}
#endif
#endif
