export type AlarmWords = { cause: string; consequence: string; action: string };
type Row = AlarmWords & { title: string };
export const alarms: Record<'en' | 'uk' | 'zh' | 'de' | 'ru', Record<string, Row>> = { en: {}, uk: {}, zh: {}, de: {}, ru: {} };
