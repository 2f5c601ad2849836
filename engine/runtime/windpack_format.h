#ifndef WINDLOOM_RUNTIME_WINDPACK_FORMAT_H
#define WINDLOOM_RUNTIME_WINDPACK_FORMAT_H
/* Layout of a .windpack, versions 1 and 2, shared by its reader and its writer. docs/windpack.md is the
 * description for everybody else. All numbers are little-endian. */

#define WINDPACK_MAGIC "WINDPACK" /* 8 bytes, no terminator */
#define WINDPACK_VERSION 2u       /* what the writer writes */
#define WINDPACK_ENDIAN_MARK 0x01020304u
#define WINDPACK_V1_HEADER_BYTES 80u
#define WINDPACK_HEADER_BYTES 96u
#define WINDPACK_CHECKSUM_BYTES 4u
#define WINDPACK_HALF_CELL_BYTES 4u  /* two half floats */
#define WINDPACK_FLOAT_CELL_BYTES 8u /* two floats */

/* Offsets in the header; the first 80 bytes are the same in both versions. */
#define WINDPACK_AT_VERSION 8u           /* u32 */
#define WINDPACK_AT_ENDIAN_MARK 12u      /* u32 */
#define WINDPACK_AT_FLAGS 16u            /* u32 */
#define WINDPACK_AT_WIDTH 20u            /* u32 */
#define WINDPACK_AT_HEIGHT 24u           /* u32 */
#define WINDPACK_AT_FRAMES 28u           /* u32 */
#define WINDPACK_AT_MIN_X 32u            /* f32 */
#define WINDPACK_AT_MIN_Z 36u            /* f32 */
#define WINDPACK_AT_MAX_X 40u            /* f32 */
#define WINDPACK_AT_MAX_Z 44u            /* f32 */
#define WINDPACK_AT_FPS 48u              /* f32 */
#define WINDPACK_AT_MAX_SPEED 52u        /* f32 */
#define WINDPACK_AT_START 56u            /* f64 */
#define WINDPACK_AT_DATA_BYTES 64u       /* u64: of the cells, before compression */
#define WINDPACK_AT_RESERVED 72u         /* u64, 0 */
#define WINDPACK_AT_QUANTITY 80u         /* u32, from here on version 2 only */
#define WINDPACK_AT_REFERENCE_HEIGHT 84u /* f32 */
#define WINDPACK_AT_ROUGHNESS 88u        /* f32 */
#define WINDPACK_AT_RESERVED_2 92u       /* u32, 0 */

#define WINDPACK_FLAG_LOOP 1u
#define WINDPACK_FLAG_WRAP_X 2u
#define WINDPACK_FLAG_WRAP_Z 4u
#define WINDPACK_FLAG_FLOAT32 8u
#define WINDPACK_FLAG_ZSTD 16u
#define WINDPACK_V1_FLAGS 7u
#define WINDPACK_V2_FLAGS 31u

#define WINDPACK_QUANTITY_WIND 0u
#define WINDPACK_QUANTITY_BEND 1u

#define WINDPACK_MAX_SIDE 8192u
#define WINDPACK_MAX_FRAMES 100000u
#define WINDPACK_MAX_DATA_BYTES (16ull << 30)
#define WINDPACK_MAX_COORDINATE 1e7f /* m */
/* Heights of the profile, m: between these, everything that is computed from them is a number. */
#define WINDPACK_MIN_REFERENCE_HEIGHT 1e-3f
#define WINDPACK_MIN_ROUGHNESS 1e-6f
#define WINDPACK_MAX_PROFILE_HEIGHT 1e4f
#define WINDPACK_MAX_HALF 65504.0f
/* A zstd block of 128 KiB takes four bytes at least, so nothing is packed tighter than this. */
#define WINDPACK_MAX_COMPRESSION 32768u

#endif
