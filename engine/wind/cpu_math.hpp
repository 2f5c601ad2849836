// exp(x) for x <= 0 in the vectors of one instruction set, with the same bytes on all. Relative error below 3e-7; below
// -80 as at -80. Included inside HWY_NAMESPACE by files compiled for several instruction sets. Cody & Waite, Software
// Manual for the Elementary Functions, 1980 (argument reduction).
template <class D>
HWY_ATTR HWY_INLINE hn::Vec<D> expNegative(D d, hn::Vec<D> x) {
  const hn::RebindToSigned<D> di;
  x = hn::Max(x, hn::Set(d, -80.0f));
  const auto whole = hn::NearestInt(hn::Mul(x, hn::Set(d, 1.44269504f)));
  const auto n = hn::ConvertTo(d, whole);
  const auto r = hn::Add(hn::Sub(x, hn::Mul(n, hn::Set(d, 0.693359375f))), hn::Mul(n, hn::Set(d, 2.12194440e-4f)));
  auto p = hn::Set(d, 1.9875691e-4f);
  for (const float c : {1.3981999e-3f, 8.3334519e-3f, 4.1665795e-2f, 1.6666665e-1f, 0.5f})
    p = hn::Add(hn::Mul(p, r), hn::Set(d, c));
  p = hn::Add(hn::Add(hn::Mul(hn::Mul(p, r), r), r), hn::Set(d, 1.0f));
  const auto power = hn::BitCast(d, hn::ShiftLeft<23>(hn::Add(whole, hn::Set(di, 127))));
  return hn::Mul(p, power);
}
