// Where the cycles of the pressure solve keep what takes turns on level 0: cycle c, from 0, has A p in half c % 2 of
// its buffer, and its residual for even c in `flux`, for odd c behind `applied`.

int planeSize() { return wind.width * wind.height; }
int halfOf(uint cycle) { return int(cycle & 1u) * planeSize(); }
float residualOf(uint cycle, int cell) { return (cycle & 1u) == 0u ? flux[cell] : applied[planeSize() + cell]; }
