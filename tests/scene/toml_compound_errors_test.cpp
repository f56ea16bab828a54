// What can be wrong with compounds, with materials that are missing, and with the text itself.

#include "tests/scene/error_of.hpp"

#include <gtest/gtest.h>

namespace rayscope {
namespace {

// Three solids and a material on line 1; the equations of the test stand in [compounds] from line 3.
std::string error_in_compounds(const std::string& lines) {
    return error_of(
        "generics = { outer = { shape = \"sphere\" }, inner = { shape = \"cube\" }, leaf = { shape = "
        "\"triangle\", vertices = [[0,0,0],[1,0,0],[0,1,0]], visible = false } }\n"
        "materials = { glass = {} }\n[compounds]\nmaterial = \"glass\"\n" +
        lines);
}

TEST(SceneErrors, UnknownMaterialNamesNearMatch) {
    EXPECT_EQ(error_of("[materials.glass]\n[generics.a]\nshape = \"sphere\"\nmaterial = \"glas\"\n"),
              "s.toml:4:12: unknown material 'glas'; did you mean 'glass'?");
    EXPECT_EQ(error_of("[materials.glass]\n[generics.a]\nshape = \"sphere\"\nmaterial = \"lgass\"\n"),
              "s.toml:4:12: unknown material 'lgass'; did you mean 'glass'?");
    EXPECT_EQ(error_of("[materials.glass]\n[generics.a]\nshape = \"sphere\"\nmaterial = \"wood\"\n"),
              "s.toml:4:12: unknown material 'wood'");
}

TEST(SceneErrors, UnknownSolidPointsIntoTheExpression) {
    EXPECT_EQ(error_in_compounds("bowl = \"(outer - iner)\"\n"),
              "s.toml:5:18: unknown solid 'iner'; did you mean 'inner'?");
    EXPECT_EQ(error_in_compounds("bowl = 'outer ∪ iner'\n"),
              "s.toml:5:17: unknown solid 'iner'; did you mean 'inner'?");
    EXPECT_EQ(error_in_compounds("bowl = \"\"\"\nouter\n  | iner\"\"\"\n"),
              "s.toml:7:5: unknown solid 'iner'; did you mean 'inner'?");
    EXPECT_EQ(error_in_compounds("bowl = \"\"\"\r\n iner\"\"\"\r\n"),
              "s.toml:6:2: unknown solid 'iner'; did you mean 'inner'?");
    EXPECT_EQ(error_in_compounds("bowl = '''outer | iner'''\n"),
              "s.toml:5:19: unknown solid 'iner'; did you mean 'inner'?");
    // Escapes: the string's own place.
    EXPECT_EQ(error_in_compounds("bowl = \"outer \\u007c iner\"\n"),
              "s.toml:5:8: unknown solid 'iner'; did you mean 'inner'?");
}

TEST(SceneErrors, ExpressionsPointAtTheColumn) {
    EXPECT_EQ(error_in_compounds("bowl = \"outer - - inner\"\n"),
              "s.toml:5:17: expected a name, '!' or '(', found '-'");
    EXPECT_EQ(error_in_compounds("bowl = \"outer ∩ ∪ inner\"\n"),
              "s.toml:5:17: expected a name, '!' or '(', found '∪'");
    EXPECT_EQ(error_in_compounds("bowl = \"(outer\"\n"), "s.toml:5:9: this '(' is never closed");
    EXPECT_EQ(error_in_compounds("bowl = \"outer -\"\n"),
              "s.toml:5:16: expected a name, '!' or '(', found the end");
    EXPECT_EQ(error_in_compounds("bowl = \"\"\n"), "s.toml:5:9: the expression is empty: expected a name");
    EXPECT_EQ(error_in_compounds("a = \"outer\"\nbowl = { is = \"outer inner\" }\n"),
              "s.toml:6:22: expected an operator (|, & or -), found 'inner'");
}

TEST(SceneErrors, CyclesAreNamed) {
    EXPECT_EQ(error_in_compounds("a = \"outer - a\"\n"),
              "s.toml:5:14: a compound can't contain itself: a → a");
    EXPECT_EQ(error_in_compounds("a = \"outer - b\"\nb = \"!c\"\nc = \"inner & b\"\n"),
              "s.toml:7:14: a compound can't contain itself: b → c → b");
    // Twice the same operand is no circle.
    EXPECT_EQ(error_in_compounds("a = \"b | c\"\nb = \"outer\"\nc = \"b - inner\"\n"), "no error");
}

TEST(SceneErrors, CompoundTables) {
    EXPECT_EQ(error_in_compounds("a = 3\n"), "s.toml:5:5: 'a': expected a table, found an integer");
    EXPECT_EQ(error_in_compounds("[compounds.a]\nmaterial = \"glass\"\n"),
              "s.toml:5:12: 'a' needs 'is', for example is = \"outer - inner\"");
    EXPECT_EQ(error_in_compounds("[compounds.a]\nis = \"outer\"\nequation = \"b\"\n"),
              "s.toml:7:1: a compound has no key 'equation'; expected is, material, transform, priority or "
              "visible");
    EXPECT_EQ(error_in_compounds("outer = \"inner\"\n"),
              "s.toml:5:1: 'outer' is the name of a generic already, in line 1");
    EXPECT_EQ(error_of("[compounds]\nmaterial = \"glas\"\n"), "s.toml:2:12: unknown material 'glas'");
    EXPECT_EQ(error_of("[compounds.material]\n"), "s.toml:1:1: 'material': expected a string, found a table");
}

TEST(SceneErrors, SurfacesAreNoOperands) {
    EXPECT_EQ(error_in_compounds("a = \"outer - leaf\"\n"),
              "s.toml:5:14: 'leaf' is a polygon: a surface without volume can't be an operand");
}

TEST(SceneErrors, WhatIsDrawnNeedsAMaterial) {
    EXPECT_EQ(error_of("[generics.a]\nshape = \"sphere\"\n"),
              "s.toml:1:11: sphere 'a' is drawn and needs a material, for example material = \"NAME\" with "
              "[materials.NAME]");
    EXPECT_EQ(error_of("[generics.a]\nshape = \"sphere\"\n[compounds]\nb = \"!a\"\n"),
              "s.toml:4:1: compound 'b' is drawn and needs a material, for example material = \"NAME\" with "
              "[materials.NAME]");
    EXPECT_EQ(error_of("[generics.a]\nshape = \"sphere\"\nvisible = false\n"), "no error");
}

TEST(SceneErrors, BrokenToml) {
    EXPECT_EQ(error_of("[camera]\neye = \n"),
              "s.toml:2:7: Error while parsing key-value pair: expected value, saw '\\n'");
    EXPECT_EQ(error_of("[camera]\n[camera]\n"),
              "s.toml:2:1: Error while parsing table header: cannot redefine existing table 'camera'");
    EXPECT_EQ(error_of("a = \"\xFF\"\n"),
              "s.toml:1:6: expected text in UTF-8, found another byte: is this a scene file?");
    EXPECT_EQ(error_of(std::string_view("a\0b", 3)),
              "s.toml:1:2: expected text in UTF-8, found another byte: is this a scene file?");
    EXPECT_EQ(error_of("\xEF\xBB\xBF[camra]\n"),
              "s.toml:1:2: a scene has no key 'camra'; did you mean 'camera'?");
}

TEST(SceneErrors, WhatTheLibraryCannotTake) {
    EXPECT_EQ(
        error_of("bôwl = 1\n"),
        "s.toml:1:2: unexpected 'ô': outside of quotes TOML allows only letters without accents, digits and "
        "ASCII signs");
    EXPECT_EQ(error_of("[camera]\neye = [1, 2, 3\nup = [0, 0, 1]\n"),
              "s.toml:3:4: unexpected '=' in the list that begins in line 2: is its ']' missing?");
    EXPECT_EQ(error_of("x = 2\"¬\"\n"),
              "s.toml:1:6: unexpected '\"': expected a blank, =, comma or bracket before it");
    EXPECT_EQ(error_of("x = 2=\"¬\"\n"), "s.toml:1:6: unexpected '=': expected a value");
    EXPECT_EQ(error_of("x = [=\"¬\"]\n"),
              "s.toml:1:6: unexpected '=' in the list that begins in line 1: is its ']' missing?");
    EXPECT_EQ(
        error_of("x = \"a \\¬\"\n"),
        "s.toml:1:8: expected an escape sequence, or blanks and an ASCII character, after this backslash");
    EXPECT_EQ(
        error_of("x = \"\"\"a \\\n ¬\"\"\"\n"),
        "s.toml:1:10: expected an escape sequence, or blanks and an ASCII character, after this backslash");
    // What only looks like one of these is fine.
    EXPECT_EQ(error_of("# bôwl ' \" a.b.c.d.e.f.g.h.i.j.k\n[scene]\nmedia = 'notes' # ¬\n"), "no error");
    EXPECT_EQ(error_of("x = \"a.b.c.d.e.f.g.h.i.j ] \\\" [ = ¬\"\n").substr(0, 26),
              "s.toml:1:1: a scene has no");
    EXPECT_EQ(error_of("x = \"\"\"a\"\" ¬ \\\"\"\"\"\n").substr(0, 26), "s.toml:1:1: a scene has no");
}

// Without the guard these overflow the call stack in the library.
TEST(SceneErrors, DeepKeysAndBrackets) {
    std::string dots = "a";
    for (int i = 0; i < 1000000; ++i) dots += ".a";
    EXPECT_EQ(error_of(dots + " = 1\n"), "s.toml:1:18: this key has more than 8 dots; a scene needs 2");
    EXPECT_EQ(error_of("[" + dots + "]\n"), "s.toml:1:19: this key has more than 8 dots; a scene needs 2");
    const std::string lists(1000000, '[');
    EXPECT_EQ(error_of("a = " + lists),
              "s.toml:1:37: brackets are nested more than 32 deep; a scene needs 4");
}

TEST(SceneErrors, Files) {
    const auto error_of_file = [](const std::filesystem::path& path) -> std::string {
        try {
            (void)read_toml(path);
            return "no error";
        } catch (const InputError& error) {
            return error.what();
        }
    };
    EXPECT_EQ(error_of_file("no/such.toml"), "no/such.toml: there is no such file");
    EXPECT_EQ(error_of_file("."), ".: expected a file, this is a directory");
    EXPECT_EQ(error_of_file("/dev/null"), "/dev/null: expected a file, this is a device");
}

} // namespace
} // namespace rayscope
