#include "visualizer/cli/option_texts.hpp"

namespace rayscope::cli {
namespace {

void add_text(CLI::App& command, const char* name, Texts::Text& text, const char* value,
              const std::string& help) {
    command.add_option_function<std::string>(
               name, [&text](const std::string& given) { text = given; }, help)
        ->type_name(value)
        ->take_last(); // a second one is refused below, in words of this program
}

constexpr const char* effects_help = "for experiments: auto, all, changes to what the scene calls for such "
                                     "as +fresnel,-shadows, or a complete list";

void add_ray_options(CLI::App& command, Texts& texts) {
    add_text(command, "SCENE", texts.scene, "", std::string(scene_help) + "; without it the glass bowl");
    add_text(command, "--pixel", texts.pixel, "X,Y",
             "the pixel to trace; without it the scene's own, or its middle");
    add_text(command, "--ray", texts.ray, "ox,oy,oz,dx,dy,dz", "a ray instead: origin and direction");
    add_text(command, "--sample", texts.sample, "N",
             "which sample of the pixel; 0, its middle, without it; --heat samples of `render` tells how "
             "many it has");
    add_text(command, "--effects", texts.effects, "LIST", effects_help);
    add_text(command, "--stage", texts.stage, "NAME",
             "also tell where a stage looks for the hits: best, scan, extents, projective, light, octree, "
             "bvh, or one "
             "for each kind of ray, as `render` takes it");
}

CLI::App_p make_step(Texts& texts) {
    auto made = std::make_shared<CLI::App>("walk through one ray's recursion, decision by decision", "step");
    CLI::App& command = *made;
    add_ray_options(command, texts);
    add_text(command, "--digits", texts.digits, "N", "significant digits of numbers, 1 to 17 (6)");
    add_text(command, "--png", texts.png, "FILE", "the picture's file (rayscope-step.png)");
    command.add_flag("--all-steps", texts.all_steps,
                     "a picture for each ray, with that ray in front: FILE-0.png, FILE-1.png, …");
    command.add_flag("--no-png", texts.no_png, "text only");
    add_text(command, "--size", texts.size, "WxH", "size of the picture (1280x720)");
    add_text(command, "--why", texts.why, "NAME",
             "only why each ray did not end on this drawn object; no picture without --png");
    add_text(
        command, "--compare", texts.compare, "LIST",
        "only where the same ray with other numbers or limits, such as float,textbook, first goes another "
        "way; no picture");
    add_text(command, "--script", texts.script, "FILE",
             "carry out the commands of a file, a line each, as they are typed on a terminal; -: of standard "
             "input");
    command.add_flag("--json", texts.json,
                     "commands come from --script or standard input; each is answered by one line of JSON");
    command.add_flag("--quiz", texts.quiz, "predict each decision of the rays before it is shown");
    command.footer("On a terminal it then asks what to show next; `help` there lists the commands.\n\n"
                   "Example:\n  rayscope step glass_bowl --pixel 235,250 --digits 4\n"
                   "  rayscope step far_tiny_sphere --compare float,textbook\n");
    return made;
}

CLI::App_p make_find(Texts& texts) {
    auto made = std::make_shared<CLI::App>("find the pixels whose rays do something", "find");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "--where", texts.where, "CONDITION",
             "what an event of the pixel's trace must be, such as 'tir && depth >= 3', 'object lens', "
             "'shadow-blocked'; "
             "`info fields` in `rayscope step` lists the words");
    add_text(command, "--size", texts.size, "WxH", "size of the image, instead of the scene's");
    add_text(command, "--stage", texts.stage, "NAME",
             "find hits by this stage, and let conditions ask for its cells");
    add_text(command, "-o", texts.output, "FILE",
             "a mask: .png, white where it holds; or .pfm, at how many events");
    add_text(command, "--list", texts.listed, "N", "how many pixels to name, 0 to 100000 (12)");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    command.add_flag("--json", texts.json, "one line of JSON");
    command.footer("Example:\n  rayscope find prism --where 'tir && depth >= 3' -o tir.png\n");
    return made;
}

CLI::App_p make_diff(Texts& texts) {
    auto made = std::make_shared<CLI::App>("show where two runs of one ray first part", "diff");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "OTHER", texts.other, "", "an edited scene, whose ray of the same pixel is compared");
    add_text(command, "--pixel", texts.pixel, "X,Y",
             "the pixel to trace; without it the scene's own, or its middle");
    add_text(command, "--ray", texts.ray, "ox,oy,oz,dx,dy,dz", "a ray instead: origin and direction");
    add_text(command, "--config", texts.configurations, "LIST",
             "other numbers or limits, such as float,textbook,depth=3");
    add_text(command, "--stage", texts.stage, "NAME", "hits found by this stage, such as octree");
    add_text(command, "--digits", texts.digits, "N", "significant digits of numbers, 1 to 17 (6)");
    command.footer("Example:\n  rayscope diff glass_bowl edited.toml --pixel 235,250\n"
                   "  rayscope diff far_tiny_sphere --config float,textbook\n");
    return made;
}

CLI::App_p make_trace(Texts& texts) {
    auto made = std::make_shared<CLI::App>("write everything that one ray did to a file", "trace");
    CLI::App& command = *made;
    add_ray_options(command, texts);
    add_text(command, "-o", texts.output, "FILE",
             "the file: .json; .html, a page to walk through it; .webp, an animation of all rays; .vtm for "
             "ParaView");
    command.footer("Example:\n  rayscope trace glass_bowl --ray 0,0.2,5,0,0,-1 -o ray.json\n");
    return made;
}

CLI::App_p make_render(Texts& texts) {
    auto made = std::make_shared<CLI::App>("make the image of a scene", "render");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "-o", texts.output, "FILE", "the image: .png (sRGB), .pfm or .exr (linear, float)");
    add_text(command, "--size", texts.size, "WxH", "its size, instead of the scene's");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    add_text(command, "--config", texts.configurations, "LIST",
             "other numbers or limits than the scene's, such as float,textbook,depth=3");
    add_text(
        command, "--stage", texts.stage, "NAME",
        "how hits are found: best, scan, extents, projective, light, octree, bvh, or one for each kind "
        "of ray, "
        "such as eye=projective,shadow=light,other=octree; octree,capacity=1,least_size=0.05 limits one; "
        "the image stays the same, bit for bit");
    add_text(
        command, "--heat", texts.heat, "KIND",
        "instead of the image what each pixel costs: tests, cells, depth, time, rays, samples or "
        "dropped; or how much of its light is direct, reflected or refracted; a .png with a scale, or the "
        "numbers as .pfm");
    add_text(command, "--effects", texts.effects, "LIST", effects_help);
    add_text(
        command, "--samples", texts.samples, "N",
        "at most so many in a pixel, 1 to 4096, best a multiple of 4; more than one only where neighbouring "
        "pixels differ");
    command.add_flag("--even-samples", texts.even_samples, "as many in every pixel, to compare with");
    add_text(command, "--stats", texts.statistics, "FILE", "write times and counts to a JSON file");
    command.footer("Example:\n  rayscope render lens -o lens.png --size 1280x960\n"
                   "  rayscope render lens --stage octree --heat tests -o tests.png\n");
    return made;
}

CLI::App_p make_explain(Texts& texts) {
    auto made =
        std::make_shared<CLI::App>("tell which effects a scene calls for, and what they cost", "explain");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "--effects", texts.effects, "LIST", effects_help);
    command.add_flag("--cost", texts.cost,
                     "also render with each effect taken away, and with each that is absent added");
    command.add_flag("--energy", texts.energy, "also tell where the light comes from, and what was dropped");
    add_text(command, "-o", texts.output, "FOLDER",
             "with --cost: for each effect a picture with it, without it, and 8 times the difference; "
             "a chart, and the numbers");
    add_text(command, "--size", texts.size, "WxH",
             "size of the images (the scene's, its longer side made 192)");
    add_text(command, "--runs", texts.runs, "N", "with --cost: rounds of renders, 5 to 1000 (5)");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    command.footer("Example:\n  rayscope explain lens --cost --energy\n"
                   "  rayscope explain lens --effects +fresnel,-shadows\n");
    return made;
}

CLI::App_p make_extents(Texts& texts) {
    auto made = std::make_shared<CLI::App>("draw what each object covers of the screen", "extents");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "-o", texts.output, "FILE", "the picture (.png)");
    add_text(command, "--size", texts.size, "WxH", "size of the image, instead of the scene's");
    command.footer(
        "Each eye ray tests only the objects in its tile's list: those whose rectangle meets the tile.\n\n"
        "Example:\n  rayscope extents glass_bowl -o extents.png\n");
    return made;
}

CLI::App_p make_export(Texts& texts) {
    auto made =
        std::make_shared<CLI::App>("write a scene for another program, which makes the same image", "export");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "-o", texts.output, "FILE", "the file: .pov for POV-Ray 3.7");
    command.footer(
        "What the other program does in another way is said on stderr, and at the head of the file.\n\n"
        "Example:\n  rayscope export glass_bowl -o bowl.pov\n"
        "  povray +Ibowl.pov +W640 +H480 -A File_Gamma=sRGB\n");
    return made;
}

CLI::App_p make_accuracy(Texts& texts) {
    auto made = std::make_shared<CLI::App>("tell what accuracy costs: time against error", "accuracy");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    command.add_flag(
        "--cases", texts.cases,
        "instead of a scene: what each number type gets wrong on the oracle's hard cases, or on those "
        "of the folder that stands in place of SCENE");
    add_text(command, "-o", texts.output, "FOLDER", "also write table, chart and error maps to this folder");
    add_text(command, "--size", texts.size, "WxH",
             "size of the images (the scene's, its longer side made 96)");
    add_text(
        command, "--configs", texts.configurations, "LIST",
        "what to compare, with slashes between: default, full, an axis (scalar, method, depth, weight), or "
        "values such as float,textbook,depth=3");
    add_text(command, "--target-error", texts.target_error, "E",
             "find the cheapest with at most this relative RMSE, and prove it at the scene's own size");
    add_text(command, "--runs", texts.runs, "N", "runs of each configuration, 5 to 1000 (5)");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    add_text(command, "--reference-rays", texts.reference_rays, "N",
             "rays of the reference for each pixel, 1 to 1000000 (100000)");
    command.footer("The reference is kept in ~/.cache/rayscope; after Ctrl-C the same command goes on.\n\n"
                   "Example:\n  rayscope accuracy lens --configs scalar/float,textbook/depth -o cost\n"
                   "  rayscope accuracy --cases\n");
    return made;
}

/// The window is a program of its own, which reads its options itself (see view_command.cpp).
CLI::App_p make_view() {
    return std::make_shared<CLI::App>("open a window to walk through the rays of a scene", "view");
}

} // namespace

Commands make_commands(Texts& texts) {
    return {make_step(texts),     make_find(texts),    make_diff(texts),    make_trace(texts),
            make_render(texts),   make_explain(texts), make_extents(texts), make_export(texts),
            make_accuracy(texts), make_view()};
}

} // namespace rayscope::cli
