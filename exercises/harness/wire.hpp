#pragma once
// Arguments and answers as bytes: what goes through the pipes between the grader and a program with an exercise's code.
// A value is a tag and its content, little-endian:
//   d 8 bytes   double            s length, bytes        text          (lengths and counts: 4 bytes)
//   i 8 bytes   integer           l count, values        list
//   b 1 byte    truth value       r type, count, (name, value) …   record  (type, name: length in 1 byte, bytes)
//   n           nothing

#include "rx.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace rx::wire {

class Writer {
public:
    std::string bytes;

    template <typename N> void raw(N number) {
        char copy[sizeof number];
        std::memcpy(copy, &number, sizeof number);
        bytes.append(copy, sizeof number);
    }
    void tag(char c) { bytes += c; }
    void name(std::string_view text) {
        raw(static_cast<std::uint8_t>(text.size()));
        bytes += text;
    }
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    template <typename N> N raw() {
        N number;
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
        return number;
    }
    char tag() { return take(1)[0]; }
    /// Of the value that comes next, which stays.
    [[nodiscard]] char next_tag() const { return rest_.empty() ? '\0' : rest_.front(); }
    std::string_view take(std::size_t count) {
        if (rest_.size() < count) throw std::runtime_error("an argument ends too early");
        const std::string_view part = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return part;
    }
    std::string_view name() { return take(raw<std::uint8_t>()); }

private:
    std::string_view rest_;
};

// The fields of each record, once for both directions.
template <typename T> struct Fields;
template <typename T>
concept Record = requires { Fields<T>::type; };
template <> struct Fields<dvec2> {
    static constexpr const char* type = "dvec2";
    template <typename V, typename F> static void visit(V& v, F f) { f("x", v.x), f("y", v.y); }
};
template <> struct Fields<dvec3> {
    static constexpr const char* type = "dvec3";
    template <typename V, typename F> static void visit(V& v, F f) { f("x", v.x), f("y", v.y), f("z", v.z); }
};
template <> struct Fields<dvec4> {
    static constexpr const char* type = "dvec4";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("x", v.x), f("y", v.y), f("z", v.z), f("w", v.w);
    }
};
/// By columns, as GLM keeps it.
template <> struct Fields<dmat4> {
    static constexpr const char* type = "dmat4";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("0", v[0]), f("1", v[1]), f("2", v[2]), f("3", v[3]);
    }
};
template <> struct Fields<Ray> {
    static constexpr const char* type = "Ray";
    template <typename V, typename F> static void visit(V& v, F f) { f("o", v.o), f("d", v.d); }
};
template <> struct Fields<Hit> {
    static constexpr const char* type = "Hit";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("t", v.t), f("n", v.n), f("enter", v.enter), f("obj", v.obj);
    }
};
template <> struct Fields<Span> {
    static constexpr const char* type = "Span";
    template <typename V, typename F> static void visit(V& v, F f) { f("a", v.a), f("b", v.b); }
};
template <> struct Fields<Box> {
    static constexpr const char* type = "Box";
    template <typename V, typename F> static void visit(V& v, F f) { f("lo", v.lo), f("hi", v.hi); }
};
template <> struct Fields<Rect> {
    static constexpr const char* type = "Rect";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("x0", v.x0), f("y0", v.y0), f("x1", v.x1), f("y1", v.y1);
    }
};
template <> struct Fields<Cam> {
    static constexpr const char* type = "Cam";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("view", v.view), f("fovy", v.fovy), f("n", v.n), f("w", v.w), f("h", v.h);
    }
};
template <> struct Fields<Node> {
    static constexpr const char* type = "Node";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("op", v.op), f("l", v.l), f("r", v.r);
    }
};
template <> struct Fields<Bounce> {
    static constexpr const char* type = "Bounce";
    template <typename V, typename F> static void visit(V& v, F f) { f("local", v.local), f("kr", v.kr); }
};
template <> struct Fields<Wall> {
    static constexpr const char* type = "Wall";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("n", v.n), f("c1", v.c1), f("c2", v.c2), f("local", v.local), f("tir", v.tir);
    }
};
template <> struct Fields<Cross> {
    static constexpr const char* type = "Cross";
    template <typename V, typename F> static void visit(V& v, F f) { f("obj", v.obj), f("enter", v.enter); }
};
template <> struct Fields<Cell> {
    static constexpr const char* type = "Cell";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("t0", v.t0), f("t1", v.t1), f("objs", v.objs);
    }
};
template <> struct Fields<Found> {
    static constexpr const char* type = "Found";
    template <typename V, typename F> static void visit(V& v, F f) { f("obj", v.obj), f("tests", v.tests); }
};
template <> struct Fields<Mat> {
    static constexpr const char* type = "Mat";
    template <typename V, typename F> static void visit(V& v, F f) {
        f("kd", v.kd), f("ks", v.ks), f("kr", v.kr), f("kt", v.kt);
    }
};

inline void put(Writer& out, double value) { out.tag('d'), out.raw(value); }
inline void put(Writer& out, bool value) { out.tag('b'), out.raw(static_cast<std::uint8_t>(value)); }
template <std::integral I> void put(Writer& out, I value) {
    out.tag('i'), out.raw(static_cast<std::int64_t>(value));
}
inline void put(Writer& out, std::string_view value) {
    out.tag('s'), out.raw(static_cast<std::uint32_t>(value.size()));
    out.bytes += value;
}
inline void put(Writer& out, const std::string& value) { put(out, std::string_view(value)); }
inline void put(Writer& out, const char* value) { put(out, std::string_view(value)); }
inline void put(Writer& out, char value) { put(out, std::string_view(&value, 1)); }
template <typename T> void put(Writer& out, const std::optional<T>& value);
template <typename T> void put(Writer& out, const std::vector<T>& list);
template <Record R> void put(Writer& out, const R& record) {
    out.tag('r'), out.name(Fields<R>::type);
    std::uint8_t count = 0;
    Fields<R>::visit(record, [&](const char*, const auto&) { ++count; });
    out.raw(count);
    Fields<R>::visit(record, [&](const char* name, const auto& field) { out.name(name), put(out, field); });
}
template <typename T> void put(Writer& out, const std::optional<T>& value) {
    if (value)
        put(out, *value);
    else
        out.tag('n');
}
template <typename T> void put(Writer& out, const std::vector<T>& list) {
    out.tag('l'), out.raw(static_cast<std::uint32_t>(list.size()));
    for (const T& item : list) put(out, item);
}

[[noreturn]] inline void unexpected(char tag, const char* expected) {
    throw std::runtime_error(std::string("an argument is '") + tag + "', expected " + expected);
}
inline double number(Reader& in) {
    const char tag = in.tag();
    if (tag == 'd') return in.raw<double>();
    if (tag == 'i') return static_cast<double>(in.raw<std::int64_t>());
    unexpected(tag, "a number");
}
inline void get(Reader& in, double& value) { value = number(in); }
inline void get(Reader& in, bool& value) {
    if (const char tag = in.tag(); tag != 'b') unexpected(tag, "true or false");
    value = in.raw<std::uint8_t>() != 0;
}
template <std::integral I> void get(Reader& in, I& value) { value = static_cast<I>(number(in)); }
inline void get(Reader& in, std::string& value) {
    if (const char tag = in.tag(); tag != 's') unexpected(tag, "text");
    value = in.take(in.raw<std::uint32_t>());
}
inline void get(Reader& in, char& value) {
    std::string text;
    get(in, text);
    value = text.empty() ? '\0' : text[0];
}
template <typename T> void get(Reader& in, std::optional<T>& value);
template <typename T> void get(Reader& in, std::vector<T>& list);
/// A record may come as a list of its fields, too.
template <Record R> void get(Reader& in, R& record) {
    const char tag = in.tag();
    std::size_t count = 0, expected = 0;
    if (tag == 'r') {
        in.name();
        count = in.raw<std::uint8_t>();
    } else if (tag == 'l') {
        count = in.raw<std::uint32_t>();
    } else {
        unexpected(tag, Fields<R>::type);
    }
    Fields<R>::visit(record, [&](const char*, auto&) { ++expected; });
    if (count != expected)
        throw std::runtime_error(std::string("an argument has the wrong number of fields for ") +
                                 Fields<R>::type);
    Fields<R>::visit(record, [&](const char*, auto& field) {
        if (tag == 'r') in.name();
        get(in, field);
    });
}
template <typename T> void get(Reader& in, std::optional<T>& value) {
    if (in.next_tag() == 'n')
        in.tag();
    else
        get(in, value.emplace());
}
template <typename T> void get(Reader& in, std::vector<T>& list) {
    if (const char tag = in.tag(); tag != 'l') unexpected(tag, "a list");
    const auto count = in.raw<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) get(in, list.emplace_back());
}

/// What an argument is kept in while the function runs.
template <typename A> struct Kept {
    using type = std::remove_cvref_t<A>;
};
template <> struct Kept<std::string_view> {
    using type = std::string;
};

template <typename R, typename... A> void call(Reader& in, Writer& out, R (*function)(A...)) {
    std::tuple<typename Kept<A>::type...> arguments;
    std::apply([&](auto&... argument) { (get(in, argument), ...); }, arguments);
    put(out, std::apply(function, arguments));
}

/// Reads the number of a function and its arguments; writes what it returns.
template <typename... F> void answer(Reader& in, Writer& out, F... functions) {
    std::int64_t wanted = 0, index = 0;
    get(in, wanted);
    ((wanted == index++ ? call(in, out, functions) : void()), ...);
}

/// All of the standard input. In wire.cpp, like the next.
[[nodiscard]] std::string read_input();
/// Runs `work` and writes what it leaves in the writer to descriptor 3; the exit code says how that went.
int run_and_write(void (*work)(int count, char** words, Reader& in, Writer& out), int count, char** words);
/// The same for one call after the other, until the input ends: each and its answer behind their length, 4 bytes.
int serve(void (*work)(Reader& in, Writer& out));

} // namespace rx::wire
