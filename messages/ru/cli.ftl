cli-more-time = { $cure }; больше времени: --time-limit S
