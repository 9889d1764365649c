// Passing every number of a memory through one function: to save, restore or digest them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace whorl {

/// What a function `archive(Archive& a)` passes its numbers to, each under a name: `a("age", age);`. Takes
/// numbers, glm's vectors, and vectors of those; which are passed may depend on nothing but what was passed
/// before.
class Archive {
  public:
    Archive() = default;
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;
    virtual ~Archive() = default;

    template <class T>
    void operator()(std::string_view name, T& value) {
        pass(name, bytes(&value, 1));
    }
    template <class T>
    void operator()(std::string_view name, std::span<T> values) {
        pass(name, bytes(values.data(), values.size()));
    }
    template <class T>
    void operator()(std::string_view name, std::vector<T>& values) {
        std::uint64_t size = values.size();
        pass("number of " + std::string(name), bytes(&size, 1));
        if (size != values.size()) values.resize(size);
        pass(name, bytes(values.data(), values.size()));
    }

  protected:
    /// @param numbers their bytes, which may be read or set
    virtual void pass(std::string_view name, std::span<std::byte> numbers) = 0;

  private:
    template <class T>
    struct NumberOf {
        using Type = T;
    };
    template <class T>
    requires requires { typename T::value_type; }
    struct NumberOf<T> {
        using Type = typename T::value_type;
    };

    template <class T>
    static std::span<std::byte> bytes(T* data, std::size_t count) {
        static_assert(std::is_arithmetic_v<typename NumberOf<T>::Type> && std::is_trivially_copyable_v<T>);
        static_assert(sizeof(T) % sizeof(typename NumberOf<T>::Type) == 0);
        return std::as_writable_bytes(std::span(data, count));
    }
};

/// Copies the numbers that pass.
class SavingArchive final : public Archive {
  public:
    std::vector<std::byte> saved;

  private:
    void pass(std::string_view name, std::span<std::byte> numbers) override;
};

/// Sets the numbers that pass to saved ones.
class RestoringArchive final : public Archive {
  public:
    /// @param saved must outlive this
    explicit RestoringArchive(std::span<const std::byte> saved) : saved_(saved) {}

  private:
    /// @throws std::logic_error if more numbers pass than were saved
    void pass(std::string_view name, std::span<std::byte> numbers) override;
    std::span<const std::byte> saved_;
};

/// Makes a number from every bit of the numbers that pass: FNV-1a over words of 8 bytes.
class DigestingArchive final : public Archive {
  public:
    std::uint64_t value() const { return value_; }

  private:
    void pass(std::string_view name, std::span<std::byte> numbers) override;
    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace whorl
