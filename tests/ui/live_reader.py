"""Reads the live link's shared memory on Linux, written from the table in docs/formats.md and from engine/runtime/live_format.h,
sharing no code with the library that games link."""
import mmap
import pathlib
import struct

SLOTS, HEADER, SLOT_HEADER, SIDE = 4, 64, 64, 512
SLOT = SLOT_HEADER + SIDE * SIDE * 4


class LiveReader:
    """Holds the object, also after its name is gone."""

    def __init__(self, name):
        path = pathlib.Path("/dev/shm") / name
        with path.open("rb") as file:
            self.memory = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        magic, version, slots, slot = struct.unpack_from("=8s3I", self.memory)
        assert (magic, version, slots, slot) == (b"WINDLIVE", 1, SLOTS, SLOT), (magic, version, slots, slot)
        assert len(self.memory) == HEADER + SLOTS * SLOT, len(self.memory)

    @staticmethod
    def exists(name):
        return (pathlib.Path("/dev/shm") / name).exists()

    def ended(self):
        return struct.unpack_from("=I", self.memory, 20)[0] == 1

    def newest(self):
        return struct.unpack_from("=Q", self.memory, 24)[0]

    def field(self):
        """The newest whole field: number, time, size in cells, bounds, greatest speed, cells as (vx, vz) in m/s."""
        while True:
            number = self.newest()
            if number == 0:
                return None
            at = HEADER + number % SLOTS * SLOT
            before = struct.unpack_from("=Q", self.memory, at)[0]
            width, height, *bounds, fastest = struct.unpack_from("=2I5f", self.memory, at + 8)
            flags, time = struct.unpack_from("=Id", self.memory, at + 36)
            halves = self.memory[at + SLOT_HEADER:at + SLOT_HEADER + min(width * height, SIDE * SIDE) * 4]
            if before == 2 * number == struct.unpack_from("=Q", self.memory, at)[0]:
                values = struct.unpack(f"={width * height * 2}e", halves)
                return {"number": number, "time": time, "size": (width, height), "bounds": tuple(bounds),
                        "fastest": fastest, "flags": flags, "cells": list(zip(values[::2], values[1::2]))}
