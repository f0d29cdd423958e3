import { en, type Table } from './en';
export const ru: Table = en;
