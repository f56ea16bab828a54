// What a scene can have wrong, with the whole message and its place.

#include "tests/scene/error_of.hpp"

#include <gtest/gtest.h>

namespace rayscope {
namespace {

struct Case {
    const char* name;
    std::string text;
    std::string error;
};

void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

class SceneErrors : public testing::TestWithParam<Case> {};

TEST_P(SceneErrors, MessageAndPlace) {
    EXPECT_EQ(error_of(GetParam().text), GetParam().error) << GetParam().text;
}

std::string name_of(const testing::TestParamInfo<Case>& info) { return info.param.name; }

const Case keys_and_types[] = {
    {"UnknownSection", "[camra]\n", "s.toml:1:2: a scene has no key 'camra'; did you mean 'camera'?"},
    {"UnknownKey", "[camera]\n  lok_at = [0,0,0]\n",
     "s.toml:2:3: [camera] has no key 'lok_at'; did you mean 'look_at'?"},
    {"UnknownKeyWithoutNearMatch", "[limits]\ndepth_of_recursion = 3\n",
     "s.toml:2:1: [limits] has no key 'depth_of_recursion'; expected max_depth, min_weight, max_rays or "
     "wavelengths"},
    {"UnknownMaterialKey", "[materials.m]\ncolor = 1\n",
     "s.toml:2:1: a material has no key 'color'; expected ambient, diffuse, specular, shininess, reflection, "
     "transmission, speed, index, fresnel, absorption, abbe, cauchy or sellmeier"},
    {"KeyOfAnotherShape", "[generics.s]\nshape = \"sphere\"\nminor_radius = 0.2\n",
     "s.toml:3:1: a sphere has no key 'minor_radius'; expected shape, material, transform, priority or "
     "visible"},
    {"SectionIsNoTable", "camera = 3\n", "s.toml:1:10: 'camera': expected a table, found an integer"},
    {"SectionIsAListOfTables", "[[camera]]\n", "s.toml:1:1: 'camera': expected a table, found a list"},
    {"VectorIsANumber", "[camera]\neye = 3\n", "s.toml:2:7: 'eye': expected [x, y, z], found an integer"},
    {"VectorIsShort", "[camera]\neye = [1, 2]\n", "s.toml:2:7: 'eye': expected [x, y, z], found 2 values"},
    {"VectorHoldsAString", "[camera]\neye = [1, 2, \"3\"]\n",
     "s.toml:2:14: 'eye': expected a number of at most 1e150 in size, found a string"},
    {"ColourIsAString", "[scene]\nbackground = \"blue\"\n",
     "s.toml:2:14: 'background': expected a number or [red, green, blue], found a string"},
    {"ColourIsNegative", "[scene]\nbackground = [0, -1, 0]\n",
     "s.toml:2:18: 'background': expected a number from 0 to 1e150, found -1"},
    {"FlagIsANumber", "[scene]\nshadows = 1\n",
     "s.toml:2:11: 'shadows': expected true or false, found an integer"},
    {"ChoiceIsWrong", "[scene]\nmedia = \"note\"\n",
     "s.toml:2:9: 'media': expected priority or notes, found 'note'; did you mean 'notes'?"},
    {"IntegerHasAFraction", "[limits]\nmax_depth = 2.5\n",
     "s.toml:2:13: 'max_depth': expected an integer from 0 to 256, found a number with a fraction"},
    {"BadName", "[materials.\"my glass\"]\n",
     "s.toml:1:12: expected a name without quotes: a letter or _, then letters, digits or _"},
    {"BadNameInATable", "[materials]\n\"my glass\" = {}\n",
     "s.toml:2:1: 'my glass' is no name for a material: expected a letter or _, then letters, digits or _"},
    {"NameBeginsWithADigit", "[generics.2nd]\n",
     "s.toml:1:11: '2nd' is no name for a generic: expected a letter or _, then letters, digits or _"},
};
INSTANTIATE_TEST_SUITE_P(KeysAndTypes, SceneErrors, testing::ValuesIn(keys_and_types), name_of);

const Case numbers[] = {
    {"NotANumber", "[camera]\neye = [0, nan, 0]\n",
     "s.toml:2:11: 'eye': expected a number of at most 1e150 in size, found nan"},
    {"Infinite", "[camera]\neye = [-inf, 0, 0]\n",
     "s.toml:2:8: 'eye': expected a number of at most 1e150 in size, found -inf"},
    {"BeyondDouble", "[camera]\neye = [1e400, 0, 0]\n",
     "s.toml:2:13: Error while parsing floating-point: '1e400' could not be interpreted as a value"},
    {"TooLarge", "[camera]\neye = [1e151, 0, 0]\n",
     "s.toml:2:8: 'eye': expected a number of at most 1e150 in size, found 1e+151"},
    {"ResolutionZero", "[camera]\nresolution = [0, 10]\n",
     "s.toml:2:15: 'resolution': expected an integer from 1 to 32768, found 0"},
    {"ResolutionTooWide", "[camera]\nresolution = [32769, 10]\n",
     "s.toml:2:15: 'resolution': expected an integer from 1 to 32768, found 32769"},
    {"TooManyPixels", "[camera]\nresolution = [32768, 32768]\n",
     "s.toml:2:14: 'resolution': 32768 × 32768 are more than 10^8 pixels"},
    {"FieldOfView", "[camera]\nfield_of_view = 180\n",
     "s.toml:2:17: 'field_of_view': expected a number between 0 and 180, found 180"},
    {"Depth", "[limits]\nmax_depth = 257\n",
     "s.toml:2:13: 'max_depth': expected an integer from 0 to 256, found 257"},
    {"Weight", "[limits]\nmin_weight = -0.5\n",
     "s.toml:2:14: 'min_weight': expected a number from 0 to 1, found -0.5"},
    {"StepOutsideTheImage", "[camera]\nresolution = [64, 48]\n[step]\npixel = [64, 0]\n",
     "s.toml:4:10: 'pixel': expected an integer from 0 to 63, found 64"},
    {"Transmission", "[materials.m]\ntransmission = 1.5\n",
     "s.toml:2:16: 'transmission': expected a number from 0 to 1, found 1.5"},
    {"MoreLightThanArrives", "[materials.m]\nreflection = [0, 0.5, 0]\ntransmission = 0.75\n",
     "s.toml:3:16: reflection + transmission is 1.25, expected at most 1 in each colour"},
    {"SpeedZero", "[materials.m]\nspeed = 0\n",
     "s.toml:2:9: 'speed': expected a number from 1e-06 to 1000000, found 0"},
    {"SpeedAndIndex", "[materials.m]\nspeed = 0.5\ndiffuse = 1\nindex = 2\n",
     "s.toml:4:1: 'index' and 'speed' exclude each other, and line 2 already gives 'speed'"},
    {"IndexAndSpeed", "[scene]\nmedium = { index = 2, speed = 0.5 }\n",
     "s.toml:2:23: 'speed' and 'index' exclude each other, and line 2 already gives 'index'"},
    {"TorusTooThick", "[generics.t]\nshape = \"torus\"\nminor_radius = 1\n",
     "s.toml:3:16: 'minor_radius': expected a number between 0 and 1, found 1"},
    {"ConeIsACylinder", "[generics.t]\nshape = \"cone\"\ntop_radius = 1\n",
     "s.toml:3:14: 'top_radius': expected less than 1, the radius of the base"},
};
INSTANTIATE_TEST_SUITE_P(Numbers, SceneErrors, testing::ValuesIn(numbers), name_of);

const Case geometry[] = {
    {"EyeIsLookAt", "[camera]\neye = [1, 2, 3]\nlook_at = [1, 2, 3]\n",
     "s.toml:2:7: 'eye' and 'look_at' are the same point"},
    {"UpIsTheView", "[camera]\neye = [0, 0, 5]\nup = [0, 0, 2]\n",
     "s.toml:3:6: 'up' is parallel to the view from 'eye' to 'look_at'"},
    {"UpIsTheViewByDefault", "[camera]\neye = [0, 5, 0]\n",
     "s.toml:2:7: 'up' is parallel to the view from 'eye' to 'look_at'"},
    {"UpIsZero", "[camera]\nup = [0, 0, 0]\n", "s.toml:2:6: 'up' has length zero"},
    {"LightWithoutPlace", "[lights.lamp]\ncolour = 1\n",
     "s.toml:1:9: 'lamp' needs 'position', for example position = [4, 3, 2]"},
    {"LightOfBothKinds", "[lights.lamp]\nposition = [0,0,0]\ndirection = [0,0,1]\n",
     "s.toml:3:1: 'direction' and 'position' exclude each other, and line 2 already gives 'position'"},
    {"LightDirectionZero", "[lights.sun]\ndirection = [0, 0, 0]\n",
     "s.toml:2:13: 'direction' has length zero"},
    {"ShapeMissing", "[generics.a]\nmaterial = \"m\"\n",
     "s.toml:1:11: 'a' needs 'shape', for example shape = \"sphere\""},
    {"ShapeUnknown", "[generics.a]\nshape = \"sphear\"\n",
     "s.toml:2:9: 'shape': expected sphere, plane, cylinder, cone, cube, torus, polygon, triangle or mesh, "
     "found "
     "'sphear'; did "
     "you mean 'sphere'?"},
    {"PolygonWithoutVertices", "[generics.p]\nshape = \"polygon\"\n",
     "s.toml:1:11: 'p' needs 'vertices', for example vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"},
    {"PolygonOfTwo", "[generics.p]\nshape = \"polygon\"\nvertices = [[0,0,0],[1,0,0]]\n",
     "s.toml:3:12: a polygon needs at least 3 vertices, found 2"},
    {"PolygonOnALine", "[generics.p]\nshape = \"polygon\"\nvertices = [[0,0,0],[1,1,1],[3,3,3]]\n",
     "s.toml:3:12: the polygon encloses no area: its vertices lie on one line, or it crosses itself"},
    {"PolygonIsAPoint", "[generics.p]\nshape = \"polygon\"\nvertices = [[1,0,0],[1,0,0],[1,0,0]]\n",
     "s.toml:3:12: the vertices of the polygon are one point"},
    {"PolygonNotFlat", "[generics.p]\nshape = \"polygon\"\nvertices = [[0,0,0],[1,0,0],[1,1,0.1],[0,1,0]]\n",
     "s.toml:3:12: the polygon is not flat: vertex 2 lies 0.0499 off the plane of the others"},
    {"PolygonHardlyNotFlat",
     "[generics.p]\nshape = \"polygon\"\nvertices = [[0,0,0],[1,0,0],[1,1,5e-6],[0,1,0]]\n",
     "s.toml:3:12: the polygon is not flat: vertex 2 lies 2.5e-06 off the plane of the others"},
    {"TriangleOfFour", "[generics.p]\nshape = \"triangle\"\nvertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]]\n",
     "s.toml:3:12: a triangle has 3 vertices, found 4"},
};
INSTANTIATE_TEST_SUITE_P(Geometry, SceneErrors, testing::ValuesIn(geometry), name_of);

std::string with_transform(const std::string& list) {
    return "[generics.a]\nshape = \"cube\"\ntransform = " + list + "\n";
}

const Case transforms[] = {
    {"TransformIsNoList", with_transform("{ scale = 2 }"),
     "s.toml:3:13: 'transform': expected a list, found a table"},
    {"StepUnknown", with_transform("[{ scle = 2 }]"),
     "s.toml:3:16: a transform has no key 'scle'; did you mean 'scale'?"},
    {"StepEmpty", with_transform("[{}]"),
     "s.toml:3:14: this transform does nothing, expected for example {translate = [1, 2, 3]}"},
    {"StepOfTwo", with_transform("[{ translate = [1,2,3], scale = 2 }]"),
     "s.toml:3:37: one transform holds one step, and this one has 'translate' already: write {translate = "
     "…}, "
     "{scale = …}, the first to be applied first"},
    {"RotateWithoutAngle", with_transform("[{ rotate = [0,0,1] }]"),
     "s.toml:3:25: 'transform' needs 'angle', for example {rotate = [0, 0, 1], angle = 30}"},
    {"RotateAboutNothing", with_transform("[{ rotate = [0,0,0], angle = 3 }]"),
     "s.toml:3:25: 'rotate': the axis has length zero"},
    {"AngleWithoutAxis", with_transform("[{ rotate_x = 3, angle = 3 }]"),
     "s.toml:3:30: 'angle' belongs to 'rotate' = [x, y, z], the axis"},
    {"ScaleZero", with_transform("[{ scale = [1, 0, 1] }]"),
     "s.toml:3:24: this transform is singular: it flattens space"},
    {"ShearSingular", with_transform("[{ shear = [1, 0, 1, 0, 0, 0] }]"),
     "s.toml:3:24: this transform is singular: it flattens space"},
    {"ShearOfThree", with_transform("[{ shear = [1, 0, 1] }]"),
     "s.toml:3:24: 'shear': expected [xy, xz, yx, yz, zx, zy], found 3 values"},
    {"MirrorUnknown", with_transform("[{ mirror = \"w\" }]"),
     "s.toml:3:25: 'mirror': expected x, y or z, found 'w'"},
    {"MatrixNotAffine", with_transform("[{ matrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]] }]"),
     "s.toml:3:56: 'matrix': expected [0, 0, 0, 1] as the last row, since only affine maps keep rays "
     "straight and "
     "their t"},
    {"MatrixSingular", with_transform("[{ matrix = [[1,2,3,0],[4,5,6,0],[7,8,9,0],[0,0,0,1]] }]"),
     "s.toml:3:25: this transform is singular: it flattens space"},
    {"MatrixOfThreeRows", with_transform("[{ matrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0]] }]"),
     "s.toml:3:25: 'matrix': expected four rows of four numbers, found 3 values"},
    {"StepsLeaveTheRange", with_transform("[{ scale = 1e100 }, { scale = 1e100 }]"),
     "s.toml:3:33: up to this one, the transforms together leave the range of numbers"},
};
INSTANTIATE_TEST_SUITE_P(Transforms, SceneErrors, testing::ValuesIn(transforms), name_of);

} // namespace
} // namespace rayscope
