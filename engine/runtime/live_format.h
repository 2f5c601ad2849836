#ifndef WINDLOOM_RUNTIME_LIVE_FORMAT_H
#define WINDLOOM_RUNTIME_LIVE_FORMAT_H
/* Layout of the live link's shared memory, version 1: the POSIX shared memory object "/NAME", written by one program
 * (the editor) and read by any number of others (games). docs/windpack.md describes it. Numbers are those of the
 * machine, which writer and readers share.
 *
 * The object begins with a header of WINDLIVE_HEADER_BYTES; WINDLIVE_SLOTS slots of WINDLIVE_SLOT_BYTES follow. Field
 * number n = 1, 2, 3... lies in slot n % WINDLIVE_SLOTS. Each slot is guarded by its sequence number: 2 n where field n
 * is complete, odd while a field is being written. A reader looks at NEWEST, then at that slot's sequence, takes the
 * field over, and looks at the sequence again: where both were 2 n, no byte was changed in between.
 *
 * The writer holds an exclusive flock() of the object as long as it lives, so that readers and other writers can tell
 * an object that was left behind. All sizes are fixed by the version: nothing in the object leads a reader astray. */

#define WINDLIVE_DEFAULT_NAME "windloom"
#define WINDLIVE_MAX_NAME 64u /* bytes of a name, without a slash */

#define WINDLIVE_MAGIC "WINDLIVE" /* 8 bytes, no terminator; written last when an object is made */
#define WINDLIVE_VERSION 1u
#define WINDLIVE_MAX_SIDE 512u
#define WINDLIVE_SLOTS 4u
#define WINDLIVE_HEADER_BYTES 64u
#define WINDLIVE_SLOT_HEADER_BYTES 64u
#define WINDLIVE_CELL_BYTES 4u /* two half floats */
#define WINDLIVE_SLOT_BYTES (WINDLIVE_SLOT_HEADER_BYTES + WINDLIVE_MAX_SIDE * WINDLIVE_MAX_SIDE * WINDLIVE_CELL_BYTES)
#define WINDLIVE_BYTES (WINDLIVE_HEADER_BYTES + WINDLIVE_SLOTS * WINDLIVE_SLOT_BYTES)

/* Offsets in the header. */
#define WINDLIVE_AT_MAGIC 0u
#define WINDLIVE_AT_VERSION 8u     /* u32 */
#define WINDLIVE_AT_SLOTS 12u      /* u32, WINDLIVE_SLOTS */
#define WINDLIVE_AT_SLOT_BYTES 16u /* u32, WINDLIVE_SLOT_BYTES */
#define WINDLIVE_AT_ENDED 20u      /* u32: 0; 1 once the writer has ended the link */
#define WINDLIVE_AT_NEWEST 24u     /* u64: number of the newest field, 0 before the first */
#define WINDLIVE_AT_PROCESS 32u    /* u32: the writer's process id, for people */

/* Offsets in a slot. */
#define WINDLIVE_AT_SEQUENCE 0u   /* u64 */
#define WINDLIVE_AT_WIDTH 8u      /* u32, 1 to WINDLIVE_MAX_SIDE */
#define WINDLIVE_AT_HEIGHT 12u    /* u32 */
#define WINDLIVE_AT_MIN_X 16u     /* f32, m */
#define WINDLIVE_AT_MIN_Z 20u     /* f32 */
#define WINDLIVE_AT_MAX_X 24u     /* f32 */
#define WINDLIVE_AT_MAX_Z 28u     /* f32 */
#define WINDLIVE_AT_MAX_SPEED 32u /* f32: no cell is faster, m/s */
#define WINDLIVE_AT_FLAGS 36u     /* u32: 2 repeats along x, 4 along z, as in a .windpack */
#define WINDLIVE_AT_TIME 40u      /* f64, s in the project */

#endif
