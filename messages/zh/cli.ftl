cli-more-time = { $cure }；延长时间：--time-limit S
cli-verb-renamed = 注意：`seamwright { $former }` 现为 `seamwright { $present }`
cli-folder-not-written = { $folder }：无法写入：{ $why }
cli-unknown-language = 注意：没有语言 `{ $language }`，改用英语；可用：{ $known }
