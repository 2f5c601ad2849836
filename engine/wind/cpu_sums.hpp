// Included inside HWY_NAMESPACE by files compiled for several instruction sets.

/// Sum of products in sixteen lanes whatever the vector size, so that all instruction sets give the same bytes.
HWY_ATTR inline double productOf(const float* a, const float* b, int count) {
  const hn::CappedTag<float, 16> d;
  HWY_ALIGN float lanes[16] = {};
  int i = 0;
  for (; i + 16 <= count; i += 16) {
    for (std::size_t n = 0; n < 16; n += hn::Lanes(d)) {
      const auto product = hn::Mul(hn::LoadU(d, a + i + n), hn::LoadU(d, b + i + n));
      hn::Store(hn::Add(hn::Load(d, lanes + n), product), d, lanes + n);
    }
  }
  double sum = 0;
  for (; i < count; ++i) sum += static_cast<double>(a[i] * b[i]);
  for (const float lane : lanes) sum += static_cast<double>(lane);
  return sum;
}
