// SPDX-License-Identifier: MIT
#include "orthoball/measures/lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "generators/random.h"

namespace orthoball {
namespace {

using generators::Random;
using std::numbers::pi;
using Vector = std::array<double, 3>;

Sphere<3> sphere(Vector x, double radius) { return {x, radius * radius, radius}; }
Sphere<2> disk(double x, double y, double radius) { return {{x, y}, radius * radius, radius}; }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector sum(const Vector& a, double times, const Vector& b) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}
template <std::size_t N>
double distance(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}
double power(const Sphere<3>& sphere, const Vector& x) {
  const double off = distance(sphere.x, x);
  return (off - sphere.radius) * (off + sphere.radius);
}
// Of a point in the plane of a lens's circle.
Vector in_space(const LensFrame& frame, const Sphere<3>& first, InLens at) {
  return sum(sum(first.x, frame.lens().height[0], frame.lens().axis), 1.0, frame.in_space(at));
}

// Balls that have points in common, and three of whose spheres meet.
Sphere<3> random_sphere(Random& random) {
  return sphere({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                random.uniform(1.8, 2.2));
}

TEST(Lens, OfTwoUnitBallsLiesHalfway) {
  const Lens<3> pair = lens(sphere({1, 2, 3}, 1), sphere({1, 3, 3}, 1));
  EXPECT_EQ(pair.axis, (Vector{0, 1, 0}));
  EXPECT_EQ(pair.distance, 1.0);
  EXPECT_EQ(pair.height, (std::array<double, 2>{0.5, 0.5}));
  EXPECT_EQ(pair.radius2, 0.75);
  EXPECT_EQ(pair.radius, std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(angle(pair.opening(0)), pi / 3);
}

TEST(Lens, LiesBehindTheCentreOfABallThatIsMostlySwallowed) {
  const Lens<2> pair = lens(disk(0, 0, 2), disk(1, 0, 1.5));
  EXPECT_EQ(pair.height[0], (1 + 4 - 2.25) / 2);
  EXPECT_EQ(pair.height[1], 1 - pair.height[0]);
  EXPECT_LT(pair.height[1], 0.0);
  EXPECT_GT(angle(pair.opening(1)), pi / 2);
  EXPECT_DOUBLE_EQ(pair.radius2, 4 - pair.height[0] * pair.height[0]);
}

TEST(Lens, HasItsCircleOnBothSpheres) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Sphere<3> a = random_sphere(random), b = random_sphere(random);
    const Lens<3> pair = lens(a, b);
    if (pair.radius == 0.0) continue;  // one ball is inside the other
    EXPECT_NEAR(dot(pair.axis, pair.axis), 1.0, 1e-15);
    EXPECT_NEAR(pair.distance, distance(a.x, b.x), 1e-15);
    EXPECT_NEAR(pair.height[0] + pair.height[1], pair.distance, 1e-14);
    EXPECT_NEAR(std::hypot(pair.height[0], pair.radius), a.radius, 1e-14);
    EXPECT_NEAR(std::hypot(pair.height[1], pair.radius), b.radius, 1e-14);
    EXPECT_NEAR(pair.radius2, rough_circle2(a, b), 1e-10);
    EXPECT_NEAR(angle(pair.opening(0)), std::acos(pair.height[0] / a.radius), 1e-14);
    EXPECT_NEAR(angle(pair.opening(1)), std::acos(pair.height[1] / b.radius), 1e-14);
  }
}

TEST(Lens, OfBallsThatTouchOrAreApartIsAPoint) {
  const Lens<3> touching = lens(sphere({0, 0, 0}, 1), sphere({0, 0, 3}, 2));
  EXPECT_EQ(touching.height, (std::array<double, 2>{1, 2}));
  EXPECT_EQ(touching.radius, 0.0);
  const Lens<3> apart = lens(sphere({0, 0, 0}, 1), sphere({0, 0, 4}, 2));
  EXPECT_LE(apart.height[0], 1.0);
  EXPECT_LE(apart.height[1], 2.0);
  EXPECT_GE(apart.radius2, 0.0);
  const Lens<3> inside = lens(sphere({0, 0, 0}, 3), sphere({0, 0, 1}, 2));
  EXPECT_EQ(inside.height, (std::array<double, 2>{3, -2}));
  EXPECT_EQ(inside.radius, 0.0);
}

TEST(Lens, TakesCentresHoweverClose) {
  const Lens<3> pair = lens(sphere({0, 0, 0}, 1), sphere({3e-200, 0, 4e-200}, 1));
  EXPECT_NEAR(pair.axis[0], 0.6, 1e-15);
  EXPECT_NEAR(pair.axis[2], 0.8, 1e-15);
  EXPECT_NEAR(pair.distance / 5e-200, 1.0, 1e-15);
  EXPECT_NEAR(pair.radius, 1.0, 1e-15);
  const Lens<2> tiny = lens(disk(0, 0, 1), disk(0, 5e-324, 1));
  EXPECT_EQ(tiny.axis, (std::array<double, 2>{0, 1}));
  EXPECT_EQ(tiny.radius, 1.0);
  const Lens<2> same = lens(disk(2, 2, 1), disk(2, 2, 1));
  EXPECT_EQ(same.axis, (std::array<double, 2>{1, 0}));
  EXPECT_EQ(same.distance, 0.0);
}

TEST(Lens, KeepsTheDistanceFromTheFarPoleWhereItIsSmall) {
  // A circle near the far pole of a unit sphere: 1 + h = r^2 / (1 - h).
  const double circle2 = 1e-20;
  EXPECT_DOUBLE_EQ(above_far_pole(1.0, -1.0, circle2), 5e-21);
  EXPECT_EQ(above_far_pole(1.0, 0.5, 0.75), 1.5);
  EXPECT_EQ(above_far_pole(1.0, -0.5, 0.75), 0.5);
  EXPECT_EQ(above_far_pole(0.0, 0.0, 0.0), 0.0);
}

TEST(LensInThePlane, FindsThePointOfEqualPowerAcrossTheAxis) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    std::array<Sphere<2>, 3> disks;
    for (auto& one : disks) {
      one = disk(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(2.2, 2.4));
    }
    const Lens<2> pair = lens(disks[0], disks[1]);
    const std::array<double, 2> to{disks[2].x[0] - disks[0].x[0], disks[2].x[1] - disks[0].x[1]};
    const double side = pair.axis[0] * to[1] - pair.axis[1] * to[0];
    if (std::abs(side) < 0.1) continue;
    const double across = offset_across(pair, disks[0], disks[2]);
    EXPECT_LE(std::abs(across), pair.radius);
    if (std::abs(across) == pair.radius) continue;  // a meeting point beyond the disks
    const double left = side > 0.0 ? across : -across;
    const std::array<double, 2> at{
        disks[0].x[0] + pair.height[0] * pair.axis[0] - left * pair.axis[1],
        disks[0].x[1] + pair.height[0] * pair.axis[1] + left * pair.axis[0]};
    std::array<double, 3> powers{};
    for (std::size_t k = 0; k < 3; ++k) {
      powers[k] = std::pow(distance(disks[k].x, at), 2) - disks[k].weight;
    }
    EXPECT_NEAR(powers[0], powers[1], 1e-13);
    EXPECT_NEAR(powers[0], powers[2], 1e-12);
  }
}

TEST(LensInThePlane, FindsAnglesOfTriangles) {
  const Sphere<2> a = disk(0, 0, 0), b = disk(2, 0, 0), c = disk(1, 1, 0);
  EXPECT_DOUBLE_EQ(corner_angle(a, b, c), pi / 4);
  EXPECT_DOUBLE_EQ(corner_angle(c, a, b), pi / 2);
  EXPECT_DOUBLE_EQ(corner_angle(c, b, a), pi / 2);
  EXPECT_DOUBLE_EQ(corner_angle(disk(1, 0, 0), a, b), pi);
}

TEST(LensFrame, IsRightHandedAndOrthonormal) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const LensFrame frame(random_sphere(random), random_sphere(random));
    const Vector x = frame.in_space({1, 0}), y = frame.in_space({0, 1}), z = frame.lens().axis;
    EXPECT_NEAR(dot(x, x), 1.0, 1e-15);
    EXPECT_NEAR(dot(y, y), 1.0, 1e-15);
    EXPECT_NEAR(dot(x, y), 0.0, 1e-15);
    EXPECT_NEAR(dot(x, z), 0.0, 1e-15);
    EXPECT_NEAR(dot(y, z), 0.0, 1e-15);
    EXPECT_NEAR(x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                    x[2] * (y[0] * z[1] - y[1] * z[0]),
                1.0, 1e-15);
  }
}

TEST(LensFrame, EndsChordsOnAllThreeSpheres) {
  Random random(4);
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Sphere<3> a = random_sphere(random), b = random_sphere(random);
    const Sphere<3> c = random_sphere(random);
    const LensFrame frame(a, b);
    const Beyond beyond = frame.beyond(c);
    const Chord chord = frame.chord(beyond, meeting_height(a, b, c));
    EXPECT_NEAR(chord.apex_distance, std::hypot(beyond.apex.x, beyond.apex.y), 1e-15);
    EXPECT_GE(chord.half, 0.0);
    if (chord.half == 0.0 || chord.apex_distance < 0.1) continue;  // the spheres do not meet
    ++met;
    for (const double side : {-1.0, 1.0}) {
      const Vector end = in_space(frame, a, chord.end(side));
      EXPECT_NEAR(power(a, end), 0.0, 1e-13);
      EXPECT_NEAR(power(b, end), 0.0, 1e-13);
      EXPECT_NEAR(power(c, end), 0.0, 1e-12);
    }
    // From the earlier end to the later one counterclockwise the third ball covers the circle.
    EXPECT_GE(cross(beyond.apex, chord.end(1.0)), 0.0);
    EXPECT_LE(cross(beyond.apex, chord.end(-1.0)), 0.0);
    EXPECT_NEAR(angle(chord.half_angle()), std::acos(chord.height / frame.lens().radius), 1e-12);
    const double apex = std::atan2(beyond.apex.y, beyond.apex.x);
    const auto at = [&](double turn) {
      return in_space(frame, a,
                      {frame.lens().radius * std::cos(apex + turn),
                       frame.lens().radius * std::sin(apex + turn)});
    };
    const double half = angle(chord.half_angle());
    EXPECT_LT(power(c, at(half - 1e-3)), 0.0);
    EXPECT_GT(power(c, at(half + 1e-3)), 0.0);
  }
  EXPECT_GT(met, 200);
}

TEST(MeetingHeight, IsTheSameForAllThreePairs) {
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const std::array<Sphere<3>, 3> balls{random_sphere(random), random_sphere(random),
                                         random_sphere(random)};
    const double height = meeting_height(balls[0], balls[1], balls[2]);
    if (height < 0.05) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const LensFrame frame(balls[k], balls[(k + 1) % 3]);
      const Beyond third = frame.beyond(balls[(k + 2) % 3]);
      const double off = std::hypot(third.apex.x, third.apex.y);
      if (off < 0.1) continue;
      EXPECT_NEAR(std::sqrt(frame.lens().radius2 - third.level / off * (third.level / off)), height,
                  1e-12);
      EXPECT_EQ(frame.chord(third, height).half, height);
    }
  }
}

// A small ball about a point of the circle of radius 4 of two others: that circle is at right
// angles to the axis, and points at distance r on it are r^2 / 8 below the small ball's centre.
TEST(MeetingHeight, IsToldByTheSmallestCircle) {
  const Sphere<3> a = sphere({-3, 0, 0}, 5), b = sphere({3, 0, 0}, 5);
  for (double r = 1.0; r > 1e-12; r /= 10) {
    const Sphere<3> c = sphere({0, 4, 0}, r);
    const double expected = r * std::sqrt(1 - r * r / 64);
    const double rounding = 1e-14 + std::pow(1e-15 / r, 2);  // of 5, at right angles
    EXPECT_NEAR(meeting_height(a, b, c) / expected, 1.0, rounding);
    EXPECT_NEAR(meeting_height(a, c, b) / expected, 1.0, rounding);
    EXPECT_NEAR(meeting_height(c, a, b) / expected, 1.0, rounding);
    const LensFrame frame(a, b);
    const Chord chord = frame.chord(frame.beyond(c), meeting_height(a, b, c));
    EXPECT_NEAR(std::hypot(chord.height, chord.half), 4.0, 1e-15);
  }
}

TEST(MeetingHeight, IsNothingWhereSpheresJustMeet) {
  // Points at distance 1 from a centre in their plane, radii 1 and off by one unit in the last
  // place.
  const double up = 0x1.0000000000001p+0;
  const Sphere<3> a = sphere({1, 0, 0}, 1), b = sphere({0, 1, 0}, 1), c = sphere({-1, 0, 0}, 1);
  EXPECT_EQ(meeting_height(a, b, c), 0.0);
  EXPECT_LT(meeting_height(sphere(a.x, up), sphere(b.x, up), sphere(c.x, up)), 1e-7);
}

TEST(LensFrame, TellsWhereAThirdLiesFromTheNearerCentre) {
  const Vector e{1.0 / 3, 2.0 / 3, 2.0 / 3};
  const Sphere<3> a = sphere({0, 0, 0}, 1), b = sphere(e, 1);
  const LensFrame frame(a, b), back(b, a);
  for (const double close : {1e-3, 1e-9, 1e-14}) {
    Sphere<3> c = b;
    c.x[0] += close;
    const double off = c.x[0] - b.x[0];  // rounded
    const Beyond one = frame.beyond(c), other = back.beyond(c);
    EXPECT_NEAR(one.along[1] / off, -1.0 / 3, 1e-15);
    EXPECT_NEAR(one.along[0] + one.along[1], frame.lens().distance, 1e-15);
    EXPECT_NEAR(std::hypot(one.apex.x, one.apex.y) / off, std::sqrt(8.0) / 3, 1e-15);
    EXPECT_NEAR(one.level / other.level, 1.0, 1e-14);
    EXPECT_NEAR(one.along[1] / other.along[0], 1.0, 1e-14);
  }
}

TEST(LensFrame, PutsChordsBackIntoTheDisk) {
  const Sphere<3> a = sphere({0, 0, 0}, 1), b = sphere({0, 0, 1}, 1);
  const LensFrame frame(a, b);
  const double radius = frame.lens().radius;
  const auto chord_of = [&](const Sphere<3>& third) {
    return frame.chord(frame.beyond(third), meeting_height(a, b, third));
  };
  const Chord none = chord_of(sphere({9, 0, 0.5}, 1));
  EXPECT_EQ(none.height, radius);
  EXPECT_EQ(none.half, 0.0);
  const Chord all = chord_of(sphere({1, 0, 0.5}, 9));
  EXPECT_EQ(all.height, -radius);
  EXPECT_EQ(all.half, 0.0);
  EXPECT_EQ(angle(all.half_angle()), pi);
}

TEST(LensFrame, CrossesLinesAtTheOrthocentre) {
  Random random(5);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<Sphere<3>, 4> balls;
    for (auto& ball : balls) ball = random_sphere(random);
    const LensFrame frame(balls[0], balls[1]);
    Beyond behind = frame.beyond(balls[2]), ahead = frame.beyond(balls[3]);
    if (cross(behind.apex, ahead.apex) < 0.0) {
      std::swap(behind, ahead);
      std::swap(balls[2], balls[3]);
    }
    if (cross(behind.apex, ahead.apex) < 0.05 || frame.lens().radius == 0.0) continue;
    const InLens meeting = frame.crossing(behind, ahead);
    const double off2 = orthoball::dot(meeting, meeting);
    EXPECT_LE(off2, frame.lens().radius2 * (1 + 1e-12));
    if (off2 > frame.lens().radius2 * (1 - 1e-12)) continue;  // put back
    ++inside;
    const Vector centre = in_space(frame, balls[0], meeting);
    for (std::size_t k = 1; k < 4; ++k) {
      EXPECT_NEAR(power(balls[k], centre), power(balls[0], centre), 1e-11);
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(LensFrame, PutsCrossingsBackIntoTheDisk) {
  const LensFrame frame(sphere({0, 0, 0}, 1), sphere({0, 0, 1}, 1));
  const double radius = frame.lens().radius;
  Beyond x, y;
  x.apex = {1, 0};
  x.level = 0.5;
  y.apex = {0, 1};
  y.level = 40;
  const InLens on_line = frame.crossing(x, y);  // as far along the first line as the disk goes
  EXPECT_NEAR(on_line.x, 0.5, 1e-15);
  EXPECT_NEAR(on_line.y, std::sqrt(radius * radius - 0.25), 1e-15);
  x.level = 30;
  const InLens back = frame.crossing(x, y);
  EXPECT_NEAR(back.x, radius, 1e-15);
  EXPECT_NEAR(back.y, 0.0, 1e-15);
}

TEST(LensFrame, CrossesLinesThatAreNearlyOneOnBoth) {
  Random random(8);
  const LensFrame frame(sphere({0, 0, 0}, 1), sphere({0, 0, 1}, 1));
  for (int i = 0; i < 1000; ++i) {
    const double turn = random.uniform(0, 6.28), off = random.uniform(0.1, 3);
    const double height = random.uniform(-0.8, 0.8), flat = random.coin() ? 1e-16 : 1e-13;
    Beyond a, b;
    a.apex = {off * std::cos(turn), off * std::sin(turn)};
    a.level = off * height;
    const double scale = random.uniform(0.2, 5);
    b.apex = {scale * a.apex.x + flat * random.normal(), scale * a.apex.y + flat * random.normal()};
    b.level = scale * a.level + flat * random.normal();
    const InLens meeting = frame.crossing(a, b);
    EXPECT_LE(orthoball::dot(meeting, meeting), frame.lens().radius2 * (1 + 1e-14));
    EXPECT_NEAR(orthoball::dot(meeting, a.apex), a.level, 1e-14);
    EXPECT_NEAR(orthoball::dot(meeting, b.apex), b.level, 20 * flat + 1e-14);
  }
}

// The solid angle of the tetrahedron at one corner, by Van Oosterom and Strackee's formula.
double solid_angle(const Vector& at, const Vector& a, const Vector& b, const Vector& c) {
  const Vector x = sum(a, -1, at), y = sum(b, -1, at), z = sum(c, -1, at);
  const double nx = std::sqrt(dot(x, x)), ny = std::sqrt(dot(y, y)), nz = std::sqrt(dot(z, z));
  const double volume = x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
                        x[2] * (y[0] * z[1] - y[1] * z[0]);
  return 2 * std::atan2(std::abs(volume),
                        nx * ny * nz + dot(x, y) * nz + dot(y, z) * nx + dot(z, x) * ny);
}

TEST(LensFrame, TellsTheSolidAngleOfARegularTetrahedron) {
  const Sphere<3> a = sphere({0, 0, 0}, 1), b = sphere({1, 0, 0}, 1);
  const Sphere<3> c = sphere({0.5, std::sqrt(0.75), 0}, 1);
  const LensFrame frame(a, b);
  const Chord chord = frame.chord(frame.beyond(c), meeting_height(a, b, c));
  const double expected = 3 * std::acos(1.0 / 3) - pi;
  EXPECT_NEAR(2 * angle(frame.half_solid_angle(chord, 0, 1.0)), expected, 1e-15);
  EXPECT_NEAR(2 * angle(frame.half_solid_angle(chord, 1, 1.0)), expected, 1e-15);
}

TEST(LensFrame, TellsTheSolidAngleOfAnOctant) {
  // Spheres of radius sqrt(2) about (1, 0, 0) and (0, 1, 0) meet the unit sphere at (0, 0, 1).
  const Sphere<3> a = sphere({0, 0, 0}, 1), b = sphere({1, 0, 0}, std::sqrt(2.0));
  const Sphere<3> c = sphere({0, 1, 0}, std::sqrt(2.0));
  const LensFrame frame(a, b);
  const Chord chord = frame.chord(frame.beyond(c), meeting_height(a, b, c));
  EXPECT_NEAR(2 * angle(frame.half_solid_angle(chord, 0, 1.0)), pi / 2, 1e-15);
}

TEST(LensFrame, TellsSolidAnglesAtBothCentres) {
  Random random(6);
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    const Sphere<3> a = random_sphere(random), b = random_sphere(random);
    const Sphere<3> c = random_sphere(random);
    const LensFrame frame(a, b);
    const Chord chord = frame.chord(frame.beyond(c), meeting_height(a, b, c));
    if (chord.half < 0.05 || chord.apex_distance < 0.05 || frame.lens().distance < 0.05) continue;
    ++met;
    const Vector end = in_space(frame, a, chord.end(1.0));
    EXPECT_NEAR(2 * angle(frame.half_solid_angle(chord, 0, a.radius)),
                solid_angle(a.x, b.x, c.x, end), 1e-12);
    EXPECT_NEAR(2 * angle(frame.half_solid_angle(chord, 1, b.radius)),
                solid_angle(b.x, a.x, c.x, end), 1e-12);
  }
  EXPECT_GT(met, 200);
}

TEST(LensFrame, TellsDihedralAngles) {
  EXPECT_DOUBLE_EQ(angle(angle_between({1, 0}, {0, 2})), pi / 2);
  EXPECT_DOUBLE_EQ(angle(angle_between({2, 0}, {-1, 1})), 3 * pi / 4);
  EXPECT_EQ(angle(angle_between({1, 1}, {2, 2})), 0.0);
  EXPECT_EQ(angle(angle_between({1, 0}, {1, -1e-20})), 0.0);  // turned by rounding
}

}  // namespace
}  // namespace orthoball
