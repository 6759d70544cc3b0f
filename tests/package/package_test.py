#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""X1: builds the project in consumer/ outside the tree, against each form in which Kodo is delivered.

  install     an installed and moved tree: find_package, pkg-config, headers without warnings
  archives    the TGZ and DEB packages, unpacked elsewhere; the game runs there
  shared      a build of shared libraries, installed and packed; they export the public API alone
  subproject  add_subdirectory and FetchContent
"""
import argparse
import json
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import traceback
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # leave no __pycache__ beside the tests
import exported_api  # noqa: E402

CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"
WARNINGS = (
    "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast"
    " -Wmissing-field-initializers -Werror"
).split()
SAME_BITS = "Kodo gives the same bits on every machine"  # begins the refusal of a build
PRECISIONS = {"": [], "64": ["-DKODO_DOUBLE"]}
# Each must accept the headers. A missing compiler is named and skipped.
COMPILERS = (
    ("g++", "c++20"),
    ("g++", "c++23"),
    ("clang++", "c++20"),
    ("clang++", "c++2b"),
    ("x86_64-w64-mingw32-g++-posix", "c++20"),
)
# Each must accept kodo.h.
C_COMPILERS = (
    ("gcc", "c11"),
    ("gcc", "c2x"),
    ("clang", "c11"),
    ("x86_64-w64-mingw32-gcc-posix", "c11"),
    ("g++", "c++11"),
    ("clang++", "c++20"),
)

# Definitions that leave fields out.
PARTIAL = """
kodo::RevoluteJoint partialJoint() { return {.motorSpeed = 1}; }
kodo::JointEnds partialEnds() { return {.anchorA = {1, 0}}; }
kodo::MouseJoint partialMouse() { return {.target = {1, 0}}; }
kodo::Transform partialTransform() { return {.position = {1, 0}}; }
kodo::FieldEntry partialEntry() { return {.which = {}}; }
kodo::CollisionRecord partialRecord() { return {.partA = 1}; }
"""


def check(holds, sentence):
    if not holds:
        raise AssertionError(sentence)


def run(*command, cwd=None, **variables):
    """The stdout of a command that must succeed."""
    command = [str(word) for word in command]
    done = subprocess.run(
        command,
        cwd=cwd or work,
        env=environment | variables,
        capture_output=True,
        text=True,
        check=False,
    )
    output = done.stdout + done.stderr
    check(done.returncode == 0, f"{shlex.join(command)} ends with {done.returncode}:\n{output}")
    return done.stdout


def check_drop(program, precision, **variables):
    """The program prints the same as drop.cpp in this build."""
    wanted = run(given.drop64 if precision else given.drop)
    printed = run(program, **variables)
    check(printed == wanted, f"{program} prints {printed}, and not {wanted}")
    check(printed.split()[1] == given.version, f"{program} is version {printed}")


def configure(source, build, *arguments, **variables):
    if shutil.which("ccache"):
        arguments += ("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache",)
    compiler = f"-DCMAKE_CXX_COMPILER={given.compiler}"
    return run("cmake", "-GNinja", "-S", source, "-B", build, compiler, *arguments, **variables)


def flags_of(build, target):
    """The flags for drop.cpp, without files and folders."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        if entry["file"].endswith("drop.cpp") and f"/{target}.dir/" in entry["command"]:
            words = words[words.index(given.compiler) + 1 :]
            files = ("-o", "-c", "-isystem")
            pairs = zip(words, ["", *words])
            words = [a for a, before in pairs if a not in files and before not in files]
            return [word for word in words if not word.startswith("-I")]
    raise AssertionError(f"{build} has no {target}")


def check_flags(build):
    """kodo::kodo gives its users the language standard, kodo::kodo64 KODO_DOUBLE as well."""
    for precision, definitions in PRECISIONS.items():
        flags = flags_of(build, f"drop{precision}")
        check(flags == [*definitions, "-std=gnu++20"], f"drop{precision} is compiled with {flags}")


def check_find_package(prefix, sfml):
    build = work / f"{prefix.name} with find_package"
    major, minor, _ = map(int, given.version.split("."))
    printed = configure(
        CONSUMER,
        build,
        f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DKODO_WANTED={major}.{minor}",
        f"-DKODO_UNWANTED={major}.{minor + 1};{major + 1}.0",
        f"-DWITH_SFML={'ON' if sfml else 'OFF'}",
    )
    check(f"kodo_VERSION {given.version}\n" in printed, f"another version in {prefix}: {printed}")
    cache = (build / "CMakeCache.txt").read_text()
    check(f"kodo_DIR:PATH={prefix}/lib/cmake/kodo\n" in cache, f"found elsewhere than in {prefix}")
    check_flags(build)
    run("cmake", "--build", build, "-j2")
    for precision in PRECISIONS:
        check_drop(build / f"drop{precision}", precision)
        if (prefix / "include/kodo.h").exists():
            check_drop(build / f"drop_c{precision}", precision)
    if sfml:
        run(build / "camera")


def check_pkg_config(prefix, sfml):
    if shutil.which("pkg-config") is None:
        print("pkg-config is missing: its files are not tested.")
        return
    path = {"PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}
    static = (prefix / "lib/libkodo.a").exists()
    libraries = {"LD_LIBRARY_PATH": "" if static else str(prefix / "lib")}

    def build(source, module):
        flags = run("pkg-config", "--cflags", "--libs", *["--static"] * static, module, **path)
        program = work / module
        source = CONSUMER / source
        run(given.compiler, source, *shlex.split(flags), "-o", program)
        return program

    for precision, definitions in PRECISIONS.items():
        module = f"kodo{precision}"
        version = run("pkg-config", "--modversion", module, **path).strip()
        check(version == given.version, f"{module}.pc is version {version}")
        flags = run("pkg-config", "--cflags-only-other", module, **path).split()
        check(flags == ["-std=c++20", *definitions], f"{module}.pc gives {flags}")
        check_drop(build("drop.cpp", module), precision, **libraries)
    if sfml:
        run(build("camera.cpp", "kodo-sfml"), **libraries)
    check_c(prefix, path)


def check_c(prefix, path):
    """The C interface by pkg-config: a program in C prints the hash of that in C++."""
    compiler = shutil.which("cc")
    if compiler is None:
        print("cc is missing: the C interface is not tested with pkg-config.")
        return
    for precision, definitions in PRECISIONS.items():
        module = f"kodo_c{precision}"
        flags = run("pkg-config", "--cflags", "--libs", module, **path).split()
        found = [flag for flag in flags if flag.startswith("-D")]
        check(found == definitions, f"{module}.pc gives {flags}")
        program = work / module
        warnings = ("-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror")
        run(compiler, *warnings, CONSUMER / "drop_c.c", *flags, "-o", program)
        check_drop(program, precision, LD_LIBRARY_PATH=str(prefix / "lib"))


def check_python(prefix):
    """The installed module finds the installed library, and runs an example."""
    path = {"PYTHONPATH": str(prefix / "lib/python3/dist-packages"), "KODO_LIBRARY": ""}
    printed = run(sys.executable, "-B", "-c", "import kodo; print(kodo.__version__)", **path)
    check(printed.strip() == given.version, f"the module kodo is version {printed}")
    example = prefix / "share/doc/kodo/python/examples/hello.py"
    wanted = (prefix / "share/doc/kodo/examples/hello.txt").read_text(encoding="utf-8")
    check(run(sys.executable, "-B", example, **path) == wanted, "hello.py prints something else")


def check_old_standard(include):
    """A user of C++17 reads what to do, in the first error."""
    source = CONSUMER / "drop.cpp"
    for compiler in ("g++", "clang++"):
        if shutil.which(compiler) is None:
            continue
        command = (compiler, "-std=c++17", "-fsyntax-only", f"-I{include}", source)
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        errors = [line for line in done.stderr.splitlines() if "error:" in line]
        check("compile with -std=c++20" in errors[0], f"{compiler} -std=c++17 says {errors[0]}")


def check_unknown_component(prefix):
    """find_package() says which component does not exist."""
    source = work / "nonsense"
    source.mkdir()
    (source / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(nonsense LANGUAGES CXX)\n"
        "find_package(kodo CONFIG REQUIRED COMPONENTS kodo kodo64 kodo_c kodo_c64)\n"
        "find_package(kodo CONFIG REQUIRED COMPONENTS nonsense)\n"
    )
    command = ("cmake", "-S", source, "-B", source / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    words = " ".join(done.stderr.split())
    check(done.returncode != 0 and 'kodo has no component "nonsense"' in words, words)


def check_documents(prefix):
    documents = prefix / "share/doc/kodo"
    for name in ("LICENSE", "CHANGELOG.md", "docs/manual.md", "examples/hello.cpp",
                 "c/examples/hello.c"):
        check((documents / name).is_file(), f"share/doc/kodo has no {name}")
    for page in (documents / "docs").glob("*.md"):
        for link in re.findall(r"\]\(([\w/-]*\.[\w./-]+)", page.read_text(encoding="utf-8")):
            check((page.parent / link).exists(), f"{page.name} links to {link}")


def check_headers_alone(include):
    """Each header includes what it needs."""
    for header in include.glob("kodo/*.hpp"):
        (work / f"alone_{header.stem}.cpp").write_text(f"#include <kodo/{header.name}>\n")
    sources = sorted(work.glob("alone_*.cpp"))
    run(given.compiler, "-std=c++20", "-fsyntax-only", f"-I{include}", *WARNINGS, *sources)


def check_warnings(include):
    """All headers and drop.cpp compile without warnings with each compiler."""
    headers = sorted(include.glob("kodo/*.hpp"))
    lines = [f"#include <kodo/{header.name}>\n" for header in headers]
    source = work / "all_headers.cpp"
    source.write_text("".join(lines) + (CONSUMER / "drop.cpp").read_text() + PARTIAL)
    for compiler, standard in COMPILERS:
        if shutil.which(compiler) is None:
            print(f"{compiler} is missing: the headers are not compiled with it.")
            continue
        flags = (f"-std={standard}", "-fsyntax-only", f"-I{include}", *WARNINGS)
        for definitions in PRECISIONS.values():
            run(compiler, *flags, *definitions, source)


def check_c_warnings(include):
    """kodo.h and drop_c.c compile without warnings as C, and kodo.h as C++."""
    (work / "header.cpp").write_text("#include <kodo.h>\n")
    for compiler, standard in C_COMPILERS:
        if shutil.which(compiler) is None:
            print(f"{compiler} is missing: kodo.h is not compiled with it.")
            continue
        in_cpp = standard.startswith("c++")
        source = work / "header.cpp" if in_cpp else CONSUMER / "drop_c.c"
        warnings = [flag for flag in WARNINGS if in_cpp or flag != "-Wold-style-cast"]
        flags = (f"-std={standard}", "-fsyntax-only", f"-I{include}", *warnings)
        for definitions in PRECISIONS.values():
            run(compiler, *flags, *definitions, source)


def check_macros(include):
    """The macros min and max of windows.h change no header."""
    headers = sorted(include.glob("kodo/*.hpp"))
    standard = {name for header in headers
                for name in re.findall(r"#include <([a-z_]+)>", header.read_text())}
    lines = [f"#include <{name}>\n" for name in sorted(standard)]
    lines += ["#define min(a, b) (a < b ? a : b)\n", "#define max(a, b) (a < b ? b : a)\n"]
    lines += [f"#include <kodo/{header.name}>\n" for header in headers]
    source = work / "macros.cpp"
    source.write_text("".join(lines))
    run(given.compiler, "-std=c++20", "-fsyntax-only", f"-I{include}", source)


def check_unknown_field(include):
    """I7: a compiler names a field that a definition does not have."""
    source = work / "unknown_field.cpp"
    source.write_text("#include <kodo/kodo.hpp>\nvoid fill(kodo::World& world) {\n"
                      "    world.add(kodo::BodyDef{.shape = kodo::Box{1, 1}, .friction = 1});\n}\n")
    for compiler, standard in COMPILERS:
        if shutil.which(compiler) is not None:
            command = (compiler, f"-std={standard}", "-fsyntax-only", f"-I{include}", source)
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            check(done.returncode != 0 and re.search(r"error: .*'?friction", done.stderr),
                  f"{compiler} does not name the field: {done.stderr[:500]}")


def check_position_independent(library):
    whole = ("-Wl,--whole-archive", library, "-Wl,--no-whole-archive")
    run(given.compiler, "-shared", "-Wl,-z,text", *whole, "-o", work / "whole.so")


def check_fused(prefix):
    """Flags of a user's file that let the compiler fuse products and sums change no bit."""
    if platform.machine() != "x86_64" or "fma" not in pathlib.Path("/proc/cpuinfo").read_text():
        print("This machine has no -mfma: it is not tested.")
        return
    for precision, definitions in PRECISIONS.items():
        hashes = {}
        for name, flags in {"plain": [], "fused": ["-mfma", "-ffp-contract=fast"]}.items():
            program = work / f"{name}{precision}"
            flags = ("-std=c++20", "-O2", *flags, *definitions, f"-I{prefix / 'include'}")
            library = prefix / f"lib/libkodo{precision}.a"
            run(given.compiler, *flags, CONSUMER / "fused.cpp", library, "-pthread", "-o", program)
            hashes[name] = run(program)
        check(len(set(hashes.values())) == 1, f"-mfma changes bits of kodo{precision}: {hashes}")


def check_unsafe(prefix):
    """No compiler accepts parts of -ffast-math without a word."""
    source = CONSUMER / "drop.cpp"
    library = prefix / "lib/libkodo.a"
    for compiler in ("g++", "clang++"):
        if shutil.which(compiler) is None:
            print(f"{compiler} is missing: parts of -ffast-math are not tested with it.")
            continue
        for flag in ("-ffast-math", "-funsafe-math-optimizations", "-ffinite-math-only",
                     "-freciprocal-math"):
            program = work / f"unsafe {compiler}"
            command = (compiler, "-std=c++20", "-O2", flag, f"-I{prefix / 'include'}", source)
            command += (library, "-pthread", "-o", program)
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode == 0:
                done = subprocess.run([program], capture_output=True, text=True, check=False)
            check(done.returncode != 0 and SAME_BITS in done.stderr,
                  f"{compiler} {flag} is accepted: {done.stderr}")


def check_debug_containers(prefix):
    """The linker refuses a program whose containers have other sizes, and names the reason."""
    for precision, definitions in PRECISIONS.items():
        library = prefix / f"lib/libkodo{precision}.a"
        command = (given.compiler, "-std=c++20", "-D_GLIBCXX_DEBUG", *definitions)
        command += (f"-I{prefix / 'include'}", CONSUMER / "drop.cpp", library, "-pthread")
        command += ("-o", work / "debug containers")
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        check(done.returncode != 0 and "_glibcxx_debug::World" in done.stderr,
              f"-D_GLIBCXX_DEBUG links libkodo{precision}.a: {done.stderr}")


def install_moved(build, name):
    """The prefix of an installed engine that was moved, and whether it has kodo::sfml."""
    sfml = (build / "engine/sfml").is_dir()
    parts = ("kodo-dev", "kodo-runtime", "kodo-c", "kodo-c-dev", "kodo-python",
             *["kodo-sfml-dev"] * sfml)
    for component in parts:
        run("cmake", "--install", build, "--prefix", work / "before", "--component", component)
    return (work / "before").rename(work / name), sfml


def install():
    prefix, sfml = install_moved(given.build, "installed")
    check_find_package(prefix, sfml)
    check_pkg_config(prefix, sfml)
    check_warnings(prefix / "include")
    check_c_warnings(prefix / "include")
    check_macros(prefix / "include")
    check_unknown_field(prefix / "include")
    for library in prefix.glob("lib/libkodo*.a"):
        check_position_independent(library)
    check_fused(prefix)
    check_unsafe(prefix)
    check_debug_containers(prefix)
    check_old_standard(prefix / "include")
    check_unknown_component(prefix)
    check_documents(prefix)
    check_python(prefix)
    check_double_is_optional()


def check_double_is_optional():
    """KODO_DOUBLE=OFF configures and installs kodo alone."""
    build = work / "float alone"
    off = [f"-D{name}=OFF" for name in ("KODO_DOUBLE", "KODO_TESTS", "KODO_SFML", "APART_GAME")]
    configure(given.source, build, *off)
    targets = run("cmake", "--build", build, "--target", "help")
    check("kodo64" not in targets, "KODO_DOUBLE=OFF has targets of kodo64")
    check(not (build / "package/kodo64.pc").exists(), "KODO_DOUBLE=OFF makes kodo64.pc")


def packages_of(build):
    """The packages that cpack makes of a build, unpacked: {file name: prefix}."""
    folder = work / "packages"
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=build)
    unpacked = {}
    for archive in sorted(path for path in folder.iterdir() if path.is_file()):
        version = archive.name.replace("_", "-").split("-")
        check(given.version in version, f"{archive.name} does not name version {given.version}")
        into = work / f"unpacked {archive.name}"
        into.mkdir()
        if archive.suffix == ".deb":
            run("dpkg-deb", "-x", archive, into)
            check_control(archive, into / "usr")
            unpacked[archive.name] = into / "usr"
        else:
            run("tar", "-xzf", archive, "-C", into)
            (unpacked[archive.name],) = into.iterdir()
    return unpacked


def check_control(archive, prefix):
    def field(name):
        return run("dpkg-deb", "-f", archive, name).strip()

    package = archive.name.partition("_")[0]
    check(field("Package") == package, f"{archive.name} holds another package")
    check(field("Version") == given.version, f"{archive.name} holds another version")
    check(field("Maintainer") == "The Kodo authors <kodo@example.org>", f"{package}: maintainer")
    check(len(field("Description").splitlines()) > 1, f"{package}: no long description")
    documents = prefix / "share/doc" / package
    check((documents / "copyright").exists(), f"{package}: no copyright")
    if package == "apart":
        check(field("Section") == "games", "apart: not in section games")
        if shutil.which("dpkg-shlibdeps"):
            check("libstdc++6" in field("Depends"), f"apart: depends on {field('Depends')}")


def check_game(prefix):
    """The game of a package reaches the same state as that of the build, with its own assets."""
    program = prefix / "bin/apart-headless"
    play = ("bot", "--level", "first_light", "--ticks", "900", "--json")
    wanted = run(given.build / "bin/apart-headless", *play)
    check(run(program, *play) == wanted, f"{program} plays another game than {wanted}")
    check("All 1 levels pass" in run(program, "lint", "first_light"), "lint fails")
    for level in prefix.glob("share/apart/levels/*.toml"):
        if level.stem != "first_light":
            level.unlink()
    check(len(run(program, "levels").splitlines()) == 1, f"{program} reads other assets")
    if (given.build / "bin/apart").exists():
        check("--level" in run(prefix / "bin/apart", "--help"), "apart --help fails")
        entry = prefix / "share/applications/apart.desktop"
        check("\nExec=apart\nIcon=apart\n" in entry.read_text(), "the desktop entry starts nothing")
        if shutil.which("desktop-file-validate"):
            run("desktop-file-validate", entry)
        xml.etree.ElementTree.parse(prefix / "share/icons/hicolor/scalable/apps/apart.svg")


def archives():
    unpacked = packages_of(given.build)
    game = (given.build / "bin/apart-headless").exists()
    games = [prefix for prefix in unpacked.values() if (prefix / "bin").exists()]
    check(not game or len(games) == len({"TGZ", "DEB"}), f"the game lies in {games}")
    for prefix in games:
        check_game(prefix)
    for name, prefix in unpacked.items():
        if name.startswith("libkodo-dev_"):
            check_find_package(prefix, False)
        elif (prefix / "include/kodo").exists():
            check_find_package(prefix, (prefix / "include/kodo_sfml").exists())


def shared():
    build = work / "build"
    configure(
        given.source,
        build,
        "-DBUILD_SHARED_LIBS=ON",
        "-DKODO_TESTS=OFF",
        "-DAPART_GAME=OFF",
        "-DCMAKE_UNITY_BUILD=ON",
        "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_CXX_FLAGS_RELEASE=-O0",  # no speed is measured, and the bits are the same
    )
    libraries = ["kodo", "kodo64", "kodo_c", "kodo_c64"]
    libraries += ["kodo_sfml"] * (build / "engine/sfml").is_dir()
    run("cmake", "--build", build, "-j2", "--target", *libraries, CCACHE_BASEDIR=str(work))
    prefix, sfml = install_moved(build, "installed")
    check(not list(prefix.glob("lib/libkodo.a")), "a static library beside the shared one")
    check_headers_alone(prefix / "include")
    check_find_package(prefix, sfml)
    check_pkg_config(prefix, sfml)
    if shutil.which("clang++"):
        for precision, definitions in PRECISIONS.items():
            library = prefix / f"lib/libkodo{precision}.so"
            found = exported_api.differences(library, prefix / "include", definitions, work)
            check(not (sentences := list(found)), "\n".join(sentences))
    else:
        print("clang++ is missing: exported symbols are not compared with the headers.")
    names = list(packages_of(build))
    runtime = f"libkodo{given.version.rpartition('.')[0]}_"
    check(any(name.startswith(runtime) for name in names), f"no package {runtime} in {names}")


def subproject():
    """Both ways have the same relative paths, so that ccache compiles the engine once."""
    archive = work / "kodo.tar.gz"
    folders = ("CMakeLists.txt", "LICENSE", "engine")
    run("tar", "-czf", archive, "-C", given.source, *folders)
    for way in ("folder", "fetch"):
        source = work / way
        shutil.copytree(CONSUMER, source)
        if way == "folder":
            (source / "kodo").mkdir()
            run("tar", "-xzf", archive, "-C", source / "kodo")
        cached = {"CCACHE_BASEDIR": str(source)}
        arguments = (f"-DWAY={way}", f"-DKODO_ARCHIVE={archive}", "-DCMAKE_UNITY_BUILD=ON")
        configure(source, source / "build", *arguments, **cached)
        check_flags(source / "build")
        run("cmake", "--build", source / "build", "-j2", "--target", "drop", **cached)
        check_drop(source / "build/drop", "")


def options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    ways = {way.__name__: way for way in (install, archives, shared, subproject)}
    parser.add_argument("way", choices=ways)
    for name in ("source", "build", "drop", "drop64"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    for name in ("version", "compiler"):
        parser.add_argument(f"--{name}", required=True)
    found = parser.parse_args()
    found.way = ways[found.way]
    return found


given = options()
environment = {
    name: value
    for name, value in os.environ.items()
    if name not in ("APART_ASSETS", "CXXFLAGS", "DESTDIR", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH")
}
environment["LC_ALL"] = "C.UTF-8"
with tempfile.TemporaryDirectory(prefix="kodo-package-") as name:
    work = pathlib.Path(name)
    try:
        given.way()
    except AssertionError as failure:
        traceback.print_tb(failure.__traceback__)
        sys.exit(f"package: {given.way.__name__}: {failure}")
