#include "engine/io/npy.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace fs = std::filesystem;

class Npy : public ::testing::Test {
 protected:
  std::string refusal(std::string_view bytes) const {
    EXPECT_TRUE(writeFileAtomically(m_folder / "bad.npy", bytes));
    const Result<NpyArray> array = readNpy(m_folder / "bad.npy");
    if (array) return "accepted";
    EXPECT_EQ(array.error().kind, ErrorKind::BadInput);
    return array.error().text();
  }
  std::size_t entries() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {})); }
  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

/// As NumPy writes it, so that the reader isn't tested against our own writer alone.
std::string numpyFile(const std::string& dictionary, std::string_view data, char version = 1) {
  std::string bytes = std::string("\x93NUMPY", 6) + version + '\0';
  bytes += static_cast<char>(dictionary.size() & 0xff);
  bytes += static_cast<char>(dictionary.size() >> 8);
  if (version > 1) bytes.append(2, '\0');
  return bytes + dictionary + std::string(data);
}

TEST_F(Npy, KeepsShapeAndValues) {
  for (const std::vector<std::size_t>& shape :
       std::vector<std::vector<std::size_t>>{{}, {3}, {2, 3}, {2, 1, 4, 2}, {0, 5}}) {
    std::size_t count = 1;
    for (const std::size_t extent : shape) count *= extent;
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = 0.1f * static_cast<float>(i) - 0.3f;
    ASSERT_TRUE(writeNpy(m_folder / "a.npy", shape, values));
    const Result<NpyArray> back = readNpy(m_folder / "a.npy");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->shape, shape);
    EXPECT_EQ(back->values, values);
  }
}

TEST_F(Npy, WritesTheHeaderNumPyWrites) {
  ASSERT_TRUE(writeNpy(m_folder / "a.npy", {1, 2}, std::vector<float>{1.0f, -2.0f}));
  const std::string bytes = readFile(m_folder / "a.npy").value();
  EXPECT_EQ(bytes.size(), 128u + 8u);
  EXPECT_EQ(bytes.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
  EXPECT_EQ(bytes.substr(10, 59), "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2), }");
  EXPECT_EQ(bytes.substr(127), std::string("\n\x00\x00\x80\x3f\x00\x00\x00\xc0", 9));
}

TEST_F(Npy, ReadsAllHeaderVersionsAndSpacings) {
  const std::string one("\x00\x00\x80\x3f", 4);
  for (const char version : {char{1}, char{2}, char{3}}) {
    EXPECT_EQ(refusal(numpyFile("{\"shape\":(1 ,), 'fortran_order' : False,'descr':'<f4'}\n", one, version)),
              "accepted");
  }
}

TEST_F(Npy, RefusesOtherTypesAndSaysWhich) {
  const std::string eight(8, '\0');
  EXPECT_NE(refusal(numpyFile("{'descr': '<f8', 'fortran_order': False, 'shape': (1,), }\n", eight)).find("'<f8'"),
            std::string::npos);
  EXPECT_NE(refusal(numpyFile("{'descr': '>f4', 'fortran_order': False, 'shape': (2,), }\n", eight)).find("'>f4'"),
            std::string::npos);
  EXPECT_NE(
      refusal(numpyFile("{'descr': [('a', '<f4')], 'fortran_order': False, 'shape': (2,), }\n", eight)).find("record"),
      std::string::npos);
  EXPECT_NE(refusal(numpyFile("{'descr': '<f4', 'fortran_order': True, 'shape': (1, 2), }\n", eight)).find("Fortran"),
            std::string::npos);
}

TEST_F(Npy, RefusesDamage) {
  const std::string good =
      numpyFile("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }\n", std::string(8, '\0'));
  EXPECT_EQ(refusal(good), "accepted");
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_NE(refusal(std::string_view(good).substr(0, length)), "accepted") << length;
  }
  EXPECT_NE(refusal(good + "x"), "accepted");
  const std::string giant = "{'descr': '<f4', 'fortran_order': False, 'shape': (4294967296, 4294967297), }\n";
  EXPECT_NE(refusal(numpyFile(giant, "")).find("cut short"), std::string::npos);
  EXPECT_NE(refusal(numpyFile("{'descr': '<f4', 'fortran_order': False, 'shape': (-2,), }\n", "")), "accepted");
}

TEST_F(Npy, AStreamAppearsOnlyWhenFinished) {
  {
    Result<NpyStream> stream = NpyStream::create(m_folder / "a.npy", {2, 2});
    ASSERT_TRUE(stream);
    ASSERT_TRUE(stream->write(std::vector<float>{1, 2}));
    EXPECT_FALSE(fs::exists(m_folder / "a.npy"));
  }
  EXPECT_EQ(entries(), 0u);
  Result<NpyStream> stream = NpyStream::create(m_folder / "a.npy", {2, 2});
  ASSERT_TRUE(stream);
  ASSERT_TRUE(stream->write(std::vector<float>{1, 2}));
  ASSERT_TRUE(stream->write(std::vector<float>{3, 4}));
  ASSERT_TRUE(stream->finish());
  EXPECT_EQ(entries(), 1u);
  EXPECT_EQ(readNpy(m_folder / "a.npy")->values, (std::vector<float>{1, 2, 3, 4}));
}

TEST_F(Npy, SaysWhereItCannotWrite) {
  const Result<NpyStream> stream = NpyStream::create(m_folder / "none" / "a.npy", {2});
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().kind, ErrorKind::Machine);
  EXPECT_NE(stream.error().text().find("a.npy"), std::string::npos);
}

}  // namespace windloom
